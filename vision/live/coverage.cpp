// Keeps what is known of the design's surface from frame to frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/coverage.h"

#include <utility>

namespace spool {

Coverage::Coverage(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                   const Camera& seen_by, const NoiseModel& noise)
    : design_(std::move(design)),
      patches_(SurfacePatches::cut(design_->samples, design_->model.parts.size())),
      readings_(patches_, seen_by, noise),
      next_(patches_, *design_->surface),
      adviser_(design_->model, *design_->surface, camera, noise) {}

void Coverage::clear() {
  readings_.clear();
  next_.clear();
  adviser_.clear();
}

void Coverage::add(const VisionState& state, const Matrix6d& covariance) {
  readings_.add(state, covariance);
}

void Coverage::tell(VisionState& state, const Matrix6d& covariance) {
  CoverageState& out = state.coverage;
  out.patches = patches_;
  const std::size_t count = patches_->all().size();
  out.sight.resize(count);
  for (std::size_t k = 0; k < count; ++k)
    out.sight[k] = readings_.is_known(k)             ? PatchSight::kKnown
                   : readings_.of(k).information > 0 ? PatchSight::kPartly
                                                     : PatchSight::kNotSeen;
  out.parts.resize(patches_->parts());
  for (std::size_t part = 0; part < out.parts.size(); ++part)
    out.parts[part] = readings_.of_part(part, covariance);
  next_.update(readings_);
  const Eigen::Matrix3d& axes = state.T_design_camera.linear();
  const auto look = next_.best(state.T_design_camera.translation(), axes.col(2), axes.col(1));
  out.advice = adviser_.advise(state, readings_, look);
  const DesignModel& model = design_->model;
  if (adviser_.trouble() != LookTrouble::kNone || model.datums.empty()) return;
  const int datum = model.datums.front();
  if (out.parts[static_cast<std::size_t>(datum)].is_seen) return;
  // Else every number carries what the joints from there on may be off by.
  out.advice = {"Look at " + model.parts[static_cast<std::size_t>(datum)].name +
                    " too: all is measured from it.",
                datum, std::nullopt};
}

}  // namespace spool
