// Where a hand may have carried the camera since the last frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/motion_prediction.h"

#include <cassert>

namespace spool {
namespace {

// A hand with a tablet: 0.3 m/s and 30 degrees a second are brisk, and tremor is half of that
// again.
constexpr double kSpeed = 0.45;  // m/s
constexpr double kTurn = 0.8;    // rad/s

Vector6d small_of(const Pose& motion) {
  Vector6d small;
  small << motion.translation(), rotation_vector(motion.linear());
  return small;
}

}  // namespace

void MotionPrediction::follow(const Pose& T_map_camera, double seconds) {
  if (T_map_last_) {
    assert(seconds > 0 && "time goes on");
    velocity_ = small_of(T_map_last_->inverse() * T_map_camera) / seconds;
  }
  T_map_last_ = T_map_camera;
}

void MotionPrediction::clear() {
  T_map_last_.reset();
  velocity_.setZero();
}

std::vector<Pose> MotionPrediction::guesses(double seconds) const {
  assert(T_map_last_ && "a last pose");
  std::vector<Pose> poses = {*T_map_last_};
  if (velocity_.isZero()) return poses;
  for (const double share : {0.5, 1.0})
    poses.push_back(*T_map_last_ * pose_from_small(share * seconds * velocity_));
  return poses;
}

Matrix6d MotionPrediction::covariance(double seconds) {
  Vector6d sigma;
  sigma << Eigen::Vector3d::Constant(kSpeed * seconds), Eigen::Vector3d::Constant(kTurn * seconds);
  return sigma.cwiseAbs2().asDiagonal();
}

}  // namespace spool
