// The acquisition box that two taps set on the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/box_session.h"

namespace spool {

namespace {
constexpr unsigned kBoxBits = 40;  // above the revisions of states: hours of them
}

void BoxSession::clear() {
  phase_ = Phase::kNone;
  frame_.reset();
  of_.reset();
  inside_.reset();
}

void BoxSession::tap(const VisionState& on, const Eigen::Vector3f& p_camera,
                     const DesignModel& design) {
  if (phase_ == Phase::kFirst) {
    first_ = p_camera;
    phase_ = Phase::kSecond;
    return;
  }
  clear();
  box_ = box_between(first_, p_camera, on.scan, design);
  frame_ = on.frame;
  is_located_ = on.camera != PoseQuality::kLost;
  T_map_taps_ = on.T_map_camera;
  map_ = on.map;
  ++boxes_;
  phase_ = Phase::kSet;
}

std::optional<Pose> BoxSession::T_taps_camera(const VisionState& state) const {
  if (state.frame == frame_) return Pose::Identity();
  if (!is_located_ || state.camera == PoseQuality::kLost || state.map != map_) return std::nullopt;
  return T_map_taps_.inverse() * state.T_map_camera;
}

const VisionStatePtr& BoxSession::seen_through(const VisionStatePtr& state) const {
  if (phase_ != Phase::kSet || !state) return state;
  if (state == of_) return inside_;
  const std::optional<Pose> T = T_taps_camera(*state);
  of_ = state;
  inside_ = state;
  if (T) {
    const AcquisitionBox box{box_.T_box_scene * *T, box_.bounds};
    inside_ = only_inside(*state, box, camera_, state->revision | (boxes_ << kBoxBits));
  }
  return inside_;
}

}  // namespace spool
