// What a shop may have done wrong: the design's assembly with one joint or part changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/defects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "tools/campaign/clearance.h"
#include "tools/campaign/standard_sizes.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kDegree = std::numbers::pi / 180;

using Candidates = std::vector<std::size_t>;

bool is_kind(const Member& member, PartKind kind) { return member.spec.kind == kind; }

// The parts that a kind of defect can befall; of a frame, tubes.
Candidates candidates_for(DefectKind kind, const Assembly& assembly) {
  Candidates fitting;
  for (std::size_t i = 0; i < assembly.members.size(); ++i) {
    const Member& m = assembly.members[i];
    if (m.missing) continue;
    const bool tube = is_kind(m, PartKind::kTube) && i > 0;  // the first is the datum
    const bool pipe = is_kind(m, PartKind::kPipe);
    const bool flange = is_kind(m, PartKind::kFlange) && m.parent >= 0;
    bool fits = false;
    switch (kind) {
      case DefectKind::kTurned:
        fits = is_kind(m, PartKind::kElbow);
        break;
      case DefectKind::kLong:
        fits = pipe || tube;
        break;
      case DefectKind::kOffset:
        fits = pipe && m.parent >= 0;
        break;
      case DefectKind::kSwapped:
        fits = m.parent >= 0 &&
               is_kind(assembly.members[static_cast<std::size_t>(m.parent)], PartKind::kTee);
        break;
      case DefectKind::kMissing:
        fits = flange || tube;
        break;
      case DefectKind::kExtra:
        fits = (pipe && m.spec.length_m > 0.1) || (tube && m.spec.length_m > 0.5);
        break;
      case DefectKind::kTilted:
      case DefectKind::kClocked:
        fits = flange;
        break;
    }
    if (fits) fitting.push_back(i);
  }
  return fitting;
}

double usual(DefectKind kind, const PartSpec& spec) {
  switch (kind) {
    case DefectKind::kTurned:
      return 90;
    case DefectKind::kLong:
      return 100;
    case DefectKind::kTilted:
      return 1;
    case DefectKind::kClocked:
      return 180.0 / sizes_of(spec.nps).holes;
    case DefectKind::kOffset:
      return 3;
    default:
      return 0;
  }
}

// What hangs on a part, as text: two branches that read alike are alike.
std::string story(const Assembly& assembly, int root) {
  std::string text;
  for (std::size_t i = 0; i < assembly.members.size(); ++i) {
    if (!hangs_on(assembly, static_cast<int>(i), root)) continue;
    const Member& m = assembly.members[i];
    text += std::to_string(static_cast<int>(m.spec.kind)) + " " + std::to_string(m.spec.nps) + " " +
            std::to_string(m.spec.length_m) + " " +
            std::to_string(static_cast<int>(i) == root ? 0 : m.roll_rad) + "; ";
  }
  return text;
}

// A branch to change places with: of the same size, unlike, neither on the other.
Candidates partners_of(std::size_t part, const Candidates& all, const Assembly& assembly) {
  const auto number = [](std::size_t i) { return static_cast<int>(i); };
  Candidates partners;
  for (const std::size_t each : all)
    if (assembly.members[each].spec.nps == assembly.members[part].spec.nps &&
        !hangs_on(assembly, number(each), number(part)) &&
        !hangs_on(assembly, number(part), number(each)) &&
        story(assembly, number(each)) != story(assembly, number(part)))
      partners.push_back(each);
  return partners;
}

// A pipe out of a pipe's side, closed by a cap, or a tube between two tubes' planes.
void add_extra(std::size_t host, Random& random, Assembly& assembly) {
  const PartSpec spec = assembly.members[host].spec;
  Pose T_host_extra = Pose::Identity();
  const double angle = spec.kind == PartKind::kTube ? std::numbers::pi / 2 * random.below(4)
                                                    : random.uniform(0, 2 * std::numbers::pi);
  T_host_extra.rotate(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
  T_host_extra.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()));
  // Neither at the very end of a pipe nor of a tube.
  T_host_extra.pretranslate(Vector3d(0, 0, spec.length_m * random.uniform(0.35, 0.65)));
  PartSpec extra = spec;
  extra.name = "extra_1";
  if (spec.kind == PartKind::kTube) {
    extra.length_m = random.uniform(0.4, 0.8);
    // On the tube's side, and not inside it.
    T_host_extra.translate(Vector3d(0, 0, spec.width_m / 2));
    assembly.weld_on(extra, static_cast<int>(host), T_host_extra);
    return;
  }
  // From the axis on: what lies inside the pipe nobody sees.
  extra.length_m = sizes_of(spec.nps).outside_diameter / 2 + random.uniform(0.12, 0.3);
  const int stub = assembly.weld_on(extra, static_cast<int>(host), T_host_extra);
  PartSpec cap{.kind = PartKind::kCap, .name = "extra_2", .nps = spec.nps};
  assembly.join(cap, stub, 1);
}

void apply(const Defect& defect, std::size_t part, std::size_t other, Random& random,
           Assembly& assembly) {
  Member& member = assembly.members[part];
  switch (defect.kind) {
    case DefectKind::kTurned:
    case DefectKind::kClocked:
      member.roll_rad += defect.amount * kDegree;
      break;
    case DefectKind::kLong:
      member.spec.length_m += defect.amount / 1000;
      break;
    case DefectKind::kSwapped: {
      Member& second = assembly.members[other];
      std::swap(member.parent, second.parent);
      std::swap(member.parent_port, second.parent_port);
      std::swap(member.roll_rad, second.roll_rad);
      break;
    }
    case DefectKind::kMissing:
      member.missing = true;
      break;
    case DefectKind::kExtra:
      add_extra(part, random, assembly);
      break;
    case DefectKind::kTilted: {
      const double towards = random.uniform(0, 2 * std::numbers::pi);
      const Vector3d axis(std::cos(towards), std::sin(towards), 0);
      member.joint_error.rotate(Eigen::AngleAxisd(defect.amount * kDegree, axis));
      break;
    }
    case DefectKind::kOffset: {
      const double towards = random.uniform(0, 2 * std::numbers::pi);
      const Vector3d aside(std::cos(towards), std::sin(towards), 0);
      member.joint_error.translate(defect.amount / 1000 * aside);
      break;
    }
  }
}

// The named part where it is among the candidates, one of them where none is named.
std::optional<std::size_t> choose(const std::string& named, const Candidates& among,
                                  const Assembly& assembly, Random& random) {
  Candidates fitting;
  for (const std::size_t each : among)
    if (named.empty() || assembly.members[each].spec.name == named) fitting.push_back(each);
  if (fitting.empty()) return std::nullopt;
  return fitting[static_cast<std::size_t>(random.below(static_cast<int>(fitting.size())))];
}

// Does the defect, and completes it with what was chosen; false where the design has no part for
// it.
bool befall(Defect& defect, Random& random, Assembly& assembly) {
  Candidates candidates = candidates_for(defect.kind, assembly);
  if (defect.kind == DefectKind::kSwapped) {
    const Candidates all = candidates;
    std::erase_if(candidates, [&](std::size_t i) { return partners_of(i, all, assembly).empty(); });
  }
  const auto part = choose(defect.part, candidates, assembly, random);
  if (!part) return false;
  auto other = part;
  if (defect.kind == DefectKind::kSwapped) {
    other = choose(defect.other, partners_of(*part, candidates, assembly), assembly, random);
    if (!other) return false;
    defect.other = assembly.members[*other].spec.name;
  }
  defect.part = assembly.members[*part].spec.name;
  if (defect.amount == 0) defect.amount = usual(defect.kind, assembly.members[*part].spec);
  apply(defect, *part, *other, random, assembly);
  return true;
}

}  // namespace

const char* name(DefectKind kind) {
  constexpr std::array kNames = {"turned", "long",   "swapped", "missing",
                                 "extra",  "tilted", "clocked", "offset"};
  return kNames[static_cast<std::size_t>(kind)];
}

Assembly with_defects(const Assembly& design, Random random, std::vector<Defect>& defects) {
  Assembly as_built = design;
  std::vector<Defect> done;
  for (const Defect& asked : defects) {
    // A shop would notice where it welds pipes into each other; a few choices may all do so.
    for (int choice = 0; choice < 12; ++choice) {
      Assembly tried = as_built;
      Defect defect = asked;
      if (!befall(defect, random, tried)) break;
      const bool frame = is_kind(design.members.front(), PartKind::kTube);
      if (choice < 11 && !frame && collides(tried, 0)) continue;
      as_built = tried;
      done.push_back(defect);
      break;
    }
  }
  defects = done;
  return as_built;
}

}  // namespace spool::campaign
