// From where a picture is seen. The only file that knows GL's eye frame (x right, y up, z back).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <glm/mat4x4.hpp>

#include "vision/core/camera.h"
#include "vision/core/pose.h"

namespace spool::render {

// A pinhole view of the design frame. `camera.width/height` are the picture's pixels.
struct View {
  Camera camera;
  Pose T_camera_design = Pose::Identity();  // camera frame: x right, y down, z forward
  double near_m = 0.05;
  double far_m = 50.0;
};

[[nodiscard]] glm::mat4 eye_from_design(const View& view);
[[nodiscard]] glm::mat4 clip_from_eye(const View& view);

// A view of `bounds` (design frame, m) that shows all of it, looking along `direction` with `up`
// upwards.
[[nodiscard]] View view_of(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& direction,
                           const Eigen::Vector3d& up, int width, int height, double fov_deg = 40.0);

// The same camera scaled into a picture of another size, whole image kept (letter-boxed by the
// principal point).
[[nodiscard]] Camera camera_in_picture(const Camera& camera, int width, int height);

// The pixel of a design point and its depth along the optical axis (m; negative: behind).
struct Projected {
  double x = 0, y = 0, depth_m = 0;
};
[[nodiscard]] Projected project(const View& view, const Eigen::Vector3d& p_design);

}  // namespace spool::render
