// Where a hand may have carried the camera since the last frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "vision/core/pose.h"

namespace spool {

// Remembers the last pose and velocity. A hand trembles at 1 to 8 Hz: the velocity of a tremor at
// 8 Hz has turned about within two frames, so a velocity is one guess among several, and the frame
// decides between them. One thread.
class MotionPrediction {
 public:
  // The pose that a frame `seconds` after the last one turned out to have. `seconds` must be over
  // zero but for the first.
  void follow(const Pose& T_map_camera, double seconds);
  // The last pose is known better; the velocity stays.
  void correct(const Pose& T_map_camera) { T_map_last_ = T_map_camera; }
  // Gives the velocity up, keeps the place: after a time without a pose.
  void stop() { velocity_.setZero(); }
  void clear();

  [[nodiscard]] bool is_known() const { return T_map_last_.has_value(); }
  [[nodiscard]] const Pose& last() const { return *T_map_last_; }
  // Guesses for `seconds` (over zero) after the last pose: standing still, moving on at half the
  // velocity, and at all of it.
  [[nodiscard]] std::vector<Pose> guesses(double seconds) const;
  // What a guess may be off by: a hand's acceleration over the time between frames, m^2 and rad^2.
  [[nodiscard]] static Matrix6d covariance(double seconds);

 private:
  std::optional<Pose> T_map_last_;
  Vector6d velocity_ = Vector6d::Zero();  // m/s, rad/s, of the camera in its own frame
};

}  // namespace spool
