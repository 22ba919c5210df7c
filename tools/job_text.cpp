// A job as text for people: its steps, what was accepted, tries, time and shrinkage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/job_text.h"

#include <fmt/format.h>

#include "app/job/job_progress.h"

namespace spool::tools {
namespace {

// "from +x" where it comes along an axis of the design, else the direction's numbers.
std::string direction_text(const Eigen::Vector3d& direction) {
  constexpr double kAlong = 0.9998;  // cosine of a degree
  const char* const kAxes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) > kAlong)
      return fmt::format("from {}{}", direction[axis] > 0 ? "+" : "-", kAxes[axis]);
  }
  return fmt::format("from ({:.3f} {:.3f} {:.3f})", direction.x(), direction.y(), direction.z());
}

}  // namespace

std::string job_text(const job::Job& job) {
  const job::JobFile& file = job.file();
  std::string text = fmt::format("spool {}, {} steps, root gap {} {:.1f} mm\n",
                                 file.spool.empty() ? "-" : file.spool, job.steps().size(),
                                 guide::name(file.gaps.rule), file.gaps.root_gap_m * 1000);
  const int current = job.current_step();
  for (int s = 0; s < static_cast<int>(job.steps().size()); ++s) {
    const guide::AssemblyStep& step = job.steps()[static_cast<std::size_t>(s)];
    const std::string& part = file.order[static_cast<std::size_t>(s)];
    const job::CheckRecord* accepted = job::accepted_record(part, job.records());
    text += fmt::format("{} {:3}  {:14} {:10}", s == current ? ">" : " ", s + 1, part,
                        accepted != nullptr ? job::name(accepted->outcome) : "open");
    for (const guide::StepJoint& joint : step.joints)
      text += fmt::format("  {} ({}) to {}, {}", joint.weld.empty() ? "no weld" : joint.weld,
                          name(joint.type),
                          job.design().parts[static_cast<std::size_t>(joint.end.neighbour)].name,
                          direction_text(joint.comes_from));
    if (step.cut)
      text += fmt::format("  cut {:.1f} mm (c-c {:.1f} mm)", step.cut->cut_m() * 1000,
                          step.cut->centre_to_centre_m() * 1000);
    text += "\n";
  }
  if (!job.damage().empty())
    return text + "what was accepted cannot be told: the journal is damaged\n";
  text += current == static_cast<int>(job.steps().size())
              ? "all steps are accepted\n"
              : fmt::format("next: step {}, {}\n", current + 1,
                            file.order[static_cast<std::size_t>(current)]);
  for (const job::JointHistory& each : job::joint_histories(job.records())) {
    text += fmt::format(
        "{}: {}, {} {}, {}{:.0f} s", each.joint, each.is_accepted ? "accepted" : "open", each.tries,
        each.tries == 1 ? "try" : "tries", each.time_is_whole ? "" : "at least ", each.seconds);
    if (each.overrides > 0) text += fmt::format(", {} by override", each.overrides);
    for (const job::Shrinkage& shrunk : each.shrinkage) {
      const bool is_length = shrunk.unit == "m";
      const double scale = is_length ? 1000 : 180 / M_PI;
      text += fmt::format(", {} {:+.2f} +- {:.2f} {} by the weld (U = 2 u)", shrunk.number,
                          shrunk.change * scale, 2 * shrunk.u * scale, is_length ? "mm" : "deg");
    }
    text += "\n";
  }
  return text;
}

}  // namespace spool::tools
