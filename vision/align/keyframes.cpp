// The keyframes that the pieces of a scan map hang on, and what that says of a camera that sees
// them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/keyframes.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace spool {
namespace {

constexpr double kApartM = 0.12, kApartRad = 0.21;

}  // namespace

Matrix6d in_axes_of(const Eigen::Matrix3d& R_map_camera, const Matrix6d& covariance) {
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_map_camera.transpose();
  return turn * covariance * turn.transpose();
}

Matrix6d step_covariance(const Matrix6d& covariance) {
  constexpr double kTogether = 2;  // standard deviations of one fit
  return (1 + kTogether * kTogether) * covariance;
}

void Keyframes::start(const Matrix6d& covariance) {
  graph_.emplace(Pose::Identity(), step_covariance(covariance));
  current_ = 0;
}

// The nearest keyframe of those that the frame was fitted to and of the current one, if it is near.
std::optional<KeyframeId> Keyframes::near(const Pose& T_map_camera,
                                          std::span<const KeyframeShare> shares) const {
  std::optional<KeyframeId> nearest;
  double least = 1;
  const auto look_at = [&](std::size_t keyframe) {
    const PoseSize apart = pose_size(graph_->T_map_keyframe(keyframe).inverse() * T_map_camera);
    const double far = std::max(apart.translation_m / kApartM, apart.rotation_rad / kApartRad);
    if (far >= least) return;
    least = far;
    nearest = static_cast<KeyframeId>(keyframe);
  };
  look_at(current_);
  for (const KeyframeShare& share : shares) look_at(share.keyframe);
  return nearest;
}

// Takes out the keyframe whose place is told best by that of the one that it came from.
void Keyframes::make_room(ScanMap& map) {
  if (graph_->size() < most_) return;
  std::size_t out = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < graph_->size(); ++i) {
    const double added = graph_->step_covariance(i).topLeftCorner<3, 3>().trace();
    if (i == current_ || added >= least) continue;
    least = added;
    out = i;
  }
  if (out == 0) return;
  const std::size_t last = graph_->size() - 1;
  // Before it takes the number of the one that goes, the last one is still itself in the map.
  const std::size_t heir = graph_->parent(out);
  map.rehang(static_cast<KeyframeId>(out), static_cast<KeyframeId>(heir));
  map.rehang(static_cast<KeyframeId>(last), static_cast<KeyframeId>(out));
  (void)graph_->take_out(out);
  if (current_ == last) current_ = out;
}

KeyframeId Keyframes::hang(const Pose& T_map_camera, std::span<const KeyframeShare> shares,
                           const Matrix6d& covariance, ScanMap& map) {
  assert(graph_ && "a map that was started");
  if (const auto nearest = near(T_map_camera, shares)) {
    current_ = *nearest;
    return *nearest;
  }
  std::size_t parent = current_;
  std::size_t most = 0;
  for (const KeyframeShare& share : shares) {
    if (share.samples <= most) continue;
    most = share.samples;
    parent = share.keyframe;
  }
  const std::size_t made =
      graph_->add(parent, graph_->T_map_keyframe(parent).inverse() * T_map_camera,
                  in_axes_of(T_map_camera.linear(), step_covariance(covariance)));
  current_ = made;
  make_room(map);
  return static_cast<KeyframeId>(current_);
}

Matrix6d Keyframes::covariance_at(const Pose& T_map_camera,
                                  std::span<const KeyframeShare> shares) const {
  Matrix6d sum = Matrix6d::Zero();
  double all = 0;
  const auto add = [&](std::size_t keyframe, double weight) {
    const Matrix6d carried =
        small_seen_from(graph_->T_map_keyframe(keyframe).inverse() * T_map_camera);
    sum += weight * carried * graph_->covariance(keyframe) * carried.transpose();
    all += weight;
  };
  for (const KeyframeShare& share : shares) add(share.keyframe, static_cast<double>(share.samples));
  if (all <= 0) add(current_, 1);
  return in_axes_of(T_map_camera.linear().transpose(), sum / all);
}

}  // namespace spool
