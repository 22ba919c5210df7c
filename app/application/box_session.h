// The acquisition box that two taps set on the scan, and the scene as it is seen through it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "vision/live/acquisition_box.h"

namespace spool {

// The box stands in the scene: a camera that is followed looks into it from wherever it goes.
class BoxSession {
 public:
  explicit BoxSession(const Camera& camera) : camera_(camera) {}

  enum class Phase { kNone, kFirst, kSecond, kSet };  // taps that are asked for
  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool is_asking() const {
    return phase_ == Phase::kFirst || phase_ == Phase::kSecond;
  }
  void ask() { phase_ = Phase::kFirst; }
  void clear();

  // One of the two taps, a point (m) in the camera frame of `on`: the same state for both.
  void tap(const VisionState& on, const Eigen::Vector3f& p_camera, const DesignModel& design);

  // The first tap while the second is awaited.
  [[nodiscard]] std::optional<Eigen::Vector3f> first() const {
    return phase_ == Phase::kSecond ? std::optional(first_) : std::nullopt;
  }

  // The state with nothing outside the box; the state itself where there is no box, or where nobody
  // knows where in the picture it is.
  [[nodiscard]] const VisionStatePtr& seen_through(const VisionStatePtr& state) const;
  [[nodiscard]] bool is_known_in(const VisionState& state) const {
    return T_taps_camera(state).has_value();
  }

 private:
  // From the camera of the state now to the camera at the taps.
  [[nodiscard]] std::optional<Pose> T_taps_camera(const VisionState& state) const;

  Camera camera_;
  Phase phase_ = Phase::kNone;
  Eigen::Vector3f first_ = Eigen::Vector3f::Zero();
  AcquisitionBox box_;                       // in the camera frame of the taps
  std::shared_ptr<const DepthFrame> frame_;  // of the taps
  bool is_located_ = false;                  // the camera's place in the scene was known there
  Pose T_map_taps_ = Pose::Identity();
  std::uint64_t map_ = 0, boxes_ = 0;
  mutable VisionStatePtr of_, inside_;  // what was asked for last, and the answer
};

}  // namespace spool
