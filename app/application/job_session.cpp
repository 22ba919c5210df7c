// The job that the screen works on: its present step, the next part's ghost, checks into the
// journal.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/job_session.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/job/job_progress.h"
#include "vision/guide/ghost_pose.h"

namespace spool {
namespace {

constexpr double kCoverage = 2;  // times the standard uncertainty

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Pose pose_of(const std::array<double, 16>& rows) {
  Pose pose;
  pose.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data());
  return pose;
}

const char* weld_word(JointType type) {
  switch (type) {
    case JointType::kField:
      return "field weld";
    case JointType::kYaw:
      return "yard weld";
    case JointType::kFab:
      break;
  }
  return "fab weld";
}

}  // namespace

Result<JobSession> JobSession::open(const std::filesystem::path& folder,
                                    std::string operator_name) {
  JournalView view;
  Result<std::unique_ptr<JobJournal>> journal = JobJournal::open(folder, view);
  if (!journal) return journal.error();
  return JobSession(std::move(*journal), std::move(view), std::move(operator_name));
}

int JobSession::part() const { return step() < steps() ? job().steps()[at(step())].part : -1; }

std::string JobSession::step_words() const {
  return step() < steps() ? fmt::format("step {} of {}", step() + 1, steps())
                          : fmt::format("all {} steps accepted", steps());
}

std::string JobSession::part_words() const {
  if (part() < 0) return {};
  const guide::AssemblyStep& step = job().steps()[at(this->step())];
  const std::vector<Part>& parts = job().design().parts;
  std::string words = parts[at(step.part)].name;
  if (step.joints.empty()) words += ": the base";
  for (std::size_t j = 0; j < step.joints.size(); ++j) {
    const guide::StepJoint& joint = step.joints[j];
    words += (j == 0 ? " onto " : " and ") + parts[at(joint.end.neighbour)].name;
    if (!joint.weld.empty()) words += " · " + joint.weld + ", " + weld_word(joint.type);
  }
  if (step.cut) words += fmt::format(" · cut {:.1f} mm", 1e3 * step.cut->cut_m());
  return words;
}

std::vector<bool> JobSession::stands() const {
  std::vector<bool> stands;
  for (const Part& part : job().design().parts)
    stands.push_back(job::accepted_record(part.name, view_.records) != nullptr);
  return stands;
}

std::optional<StepGhost> JobSession::ghost() const {
  if (part() < 0) return std::nullopt;
  const guide::AssemblyStep& step = job().steps()[at(this->step())];
  if (step.joints.empty()) return std::nullopt;
  std::vector<guide::BuiltPose> built;
  const std::vector<Part>& parts = job().design().parts;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const job::CheckRecord* record = job::accepted_record(parts[p].name, view_.records);
    if (record == nullptr || !record->T_design_part || !record->covariance) continue;
    guide::BuiltPose pose{.part = static_cast<int>(p),
                          .T_design_part = pose_of(*record->T_design_part)};
    pose.covariance =
        Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(record->covariance->data());
    built.push_back(pose);
  }
  StepGhost ghost{.part = step.part, .T_design_part = parts[at(step.part)].T_design_part};
  const auto placed = guide::ghost_pose(job().design(), step, built);
  if (!placed) return ghost;
  ghost.T_design_part = placed->T_design_part;
  ghost.is_as_built = true;
  ghost.differs = placed->distance_m > kCoverage * placed->u_distance_m ||
                  placed->angle_rad > kCoverage * placed->u_angle_rad;
  return ghost;
}

void JobSession::take_check(Captured captured) {
  view_ = std::move(captured.journal);
  // One that was on its way when its step was accepted says nothing of the next.
  if (part() >= 0 && captured.check.part == job().design().parts[at(part())].name)
    checked_ = std::move(captured.check);
}

std::string JobSession::why_not_accept() const {
  if (part() < 0) return "all steps are accepted";
  if (!checked_) return "check it first";
  if (checked_->status == "ok" || checked_->status == "suspicious") return {};
  return checked_->status == "not_ok" ? "it is out of tolerance" : "it was not measured";
}

Result<job::CheckRecord> JobSession::give_accepted() {
  if (const std::string why = why_not_accept(); !why.empty())
    return Error{ErrorCode::kUsage, "The step cannot be accepted: " + why + "."};
  job::CheckRecord record = std::move(*checked_);
  checked_.reset();
  return record;
}

}  // namespace spool
