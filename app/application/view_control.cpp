// One picture's eye.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/view_control.h"

#include <algorithm>
#include <numbers>

namespace spool {

namespace {
constexpr double kNearestPivot = 0.05;   // m
constexpr double kFurthestPivot = 30.0;  // m

Pose turn_about(const Eigen::Vector3d& point, const Eigen::Vector3d& turn_rad) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector(turn_rad);
  pose.translation() = point - pose.linear() * point;
  return pose;
}
}  // namespace

void ViewControl::start(const render::View& view, double pivot_m) {
  view_ = view;
  view_.near_m = 0.02;
  view_.far_m = 60.0;
  pivot_m_ = std::clamp(pivot_m, kNearestPivot, kFurthestPivot);
  started_ = true;
}

void ViewControl::apply(const ui::Gesture& gesture, const ui::Rect& rect) {
  const Camera& camera = view_.camera;
  if (gesture.kind == ui::Gesture::Kind::kOrbit) {
    // A finger across the picture's smaller side turns by half a turn. The near side follows the
    // finger: in the camera frame (x right, y down, z forward) that is -y for right and +x for
    // down.
    const double turn = std::numbers::pi / std::min(camera.width, camera.height);
    view_.T_camera_design =
        turn_about({0, 0, pivot_m_}, {gesture.dy * turn, -gesture.dx * turn, 0}) *
        view_.T_camera_design;
    return;
  }
  if (gesture.kind != ui::Gesture::Kind::kMove) return;
  const Eigen::Translation3d pan(gesture.dx * pivot_m_ / camera.fx,
                                 gesture.dy * pivot_m_ / camera.fy, 0);
  view_.T_camera_design = Pose(pan) * view_.T_camera_design;
  // What lies under the gesture's middle at the pivot's distance stays there.
  const Eigen::Vector3d held =
      camera.back_project(gesture.x - rect.x, gesture.y - rect.y, pivot_m_);
  view_.T_camera_design = turn_about(held, {0, 0, gesture.roll_rad}) * view_.T_camera_design;
  const double closer =
      std::clamp(pivot_m_ / gesture.factor, kNearestPivot, kFurthestPivot) / pivot_m_;
  view_.T_camera_design = Pose(Eigen::Translation3d(-(1 - closer) * held)) * view_.T_camera_design;
  pivot_m_ *= closer;
}

}  // namespace spool
