// The job on the screen: what stands and what comes next, checks into its journal, accepted steps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/application/application.h"
#include "app/application/status_mark.h"

namespace spool {

namespace {

// One part's triangles of the design, moved from its place there to `T_design_part`.
TriangleMesh part_at(const DesignModel& design, int index, const Pose& T_design_part) {
  const Part& part = design.parts[static_cast<std::size_t>(index)];
  const Eigen::Isometry3f moved = (T_design_part * part.T_design_part.inverse()).cast<float>();
  TriangleMesh mesh;
  for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(
          moved * design.mesh.vertices[design.mesh.triangles[part.first_triangle + t][k]]);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

// What stands and the present step's part are drawn; the ghost in place of the part, and beside it
// where the two places differ.
void Application::show_step() {
  if (!in_.job) return;
  const DesignModel& design = in_.design->model;
  const std::optional<StepGhost> ghost = in_.job->ghost();
  on_table_ = in_.job->stands();
  if (const int part = in_.job->part(); part >= 0) on_table_[static_cast<std::size_t>(part)] = true;
  std::vector<bool> shown = on_table_;
  if (ghost && !ghost->differs) shown[static_cast<std::size_t>(ghost->part)] = false;
  ghost_marker_.reset();
  if (!ghost) {
    picture_->show_parts(design, shown, nullptr);
    return;
  }
  const TriangleMesh mesh = part_at(design, ghost->part, ghost->T_design_part);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : mesh.vertices) box.extend(p);
  if (!box.isEmpty())
    ghost_marker_ = render::Marker{box.center(), render::Marker::Kind::kProposed,
                                   design.parts[static_cast<std::size_t>(ghost->part)].name};
  picture_->show_parts(design, shown, &mesh);
}

// Nobody picks a point of a part that is not there yet.
void Application::leave_out_absent(std::vector<double>& likelihood) const {
  if (!in_.job) return;
  likelihood.resize(landmarks_.landmarks.size(), 1.0);
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    const int part = landmarks_.landmarks[i].part;
    if (part >= 0 && !on_table_[static_cast<std::size_t>(part)]) likelihood[i] = 0;
  }
}

void Application::accept_step() {
  if (!in_.job) return;
  const int step = in_.job->step();
  Result<job::CheckRecord> check = in_.job->give_accepted();
  if (!check) {
    fail(check.error());
    return;
  }
  ++accepts_open_;
  jobs_.run([this, step, check = std::move(*check)] {
    static_cast<void>(accepted_.push(in_.job->journal().accept(step, check)));
  });
}

void Application::take_accepted() {
  while (std::optional<Result<JournalView>> answer = accepted_.try_pop()) {
    --accepts_open_;
    if (!*answer) {
      fail(answer->error());
      continue;
    }
    const std::string part = (*answer)->records.back().part;
    in_.job->take(std::move(**answer));
    show_step();
    picture_changed_ = true;  // what was checked is no longer what is to be decided
    const std::string next = in_.job->part_words();
    notice(next.empty() ? part + " accepted: all steps are."
                        : fmt::format("{} accepted. Next: {}.", part, next));
  }
}

void Application::fill_job(ui::ScreenState& out) const {
  if (!in_.job) return;
  out.step = in_.job->step_words();
  out.step_part = in_.job->part_words();
  const job::CheckRecord* checked = in_.job->checked();
  out.can_accept = checked != nullptr && in_.job->why_not_accept().empty();
  if (checked != nullptr) out.accept_word = ui::word(mark_of_status(checked->status));
}

}  // namespace spool
