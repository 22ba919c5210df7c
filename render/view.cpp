// From where a picture is seen. The only file that knows GL's eye frame (x right, y up, z back).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spool::render {
namespace {

using CornerType = Eigen::AlignedBox3d::CornerType;

}  // namespace

glm::mat4 eye_from_design(const View& view) {
  // Eye and camera frame share x; y and z are turned round.
  const Eigen::Vector4d flip(1, -1, -1, 1);
  const Eigen::Matrix4d eye = flip.asDiagonal() * view.T_camera_design.matrix();
  glm::mat4 result(1.0F);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      result[column][row] = static_cast<float>(eye(row, column));
    }
  }
  return result;
}

glm::mat4 clip_from_eye(const View& view) {
  const Camera& camera = view.camera;
  assert(camera.is_valid() && view.near_m > 0 && view.far_m > view.near_m && "a usable view");
  // Pixel centres lie at integers, so a picture reaches from -0.5 to width - 0.5:
  // x_ndc = 2 (u + 0.5) / width - 1 and, row 0 at the top, y_ndc = 1 - 2 (v + 0.5) / height, with
  // u = fx x / z + cx and v = fy y / z + cy in the camera frame (x, y, z) = (x_eye, -y_eye,
  // -z_eye).
  const double width = camera.width;
  const double height = camera.height;
  const double depth = view.far_m - view.near_m;
  glm::mat4 clip(0.0F);
  clip[0][0] = static_cast<float>(2 * camera.fx / width);
  clip[1][1] = static_cast<float>(2 * camera.fy / height);
  clip[2][0] = static_cast<float>(1 - 2 * (camera.cx + 0.5) / width);
  clip[2][1] = static_cast<float>(2 * (camera.cy + 0.5) / height - 1);
  clip[2][2] = static_cast<float>(-(view.far_m + view.near_m) / depth);
  clip[2][3] = -1.0F;
  clip[3][2] = static_cast<float>(-2 * view.far_m * view.near_m / depth);
  return clip;
}

View view_of(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& direction,
             const Eigen::Vector3d& up, int width, int height, double fov_deg) {
  assert(width > 0 && height > 0 && fov_deg > 0 && fov_deg < 180 &&
         "a picture and a field of view");
  assert(direction.norm() > 0 && "a direction to look along");
  Eigen::AlignedBox3d box = bounds;
  if (box.isEmpty())
    box = Eigen::AlignedBox3d(Eigen::Vector3d(-0.5, -0.5, -0.5), Eigen::Vector3d(0.5, 0.5, 0.5));

  const Eigen::Vector3d forward = direction.normalized();
  Eigen::Vector3d right = forward.cross(up);
  // `up` along the direction says nothing: any right angle will do.
  if (right.norm() < 1e-6 * std::max(up.norm(), 1e-300)) right = forward.unitOrthogonal();
  right.normalize();
  Eigen::Matrix3d R_camera_design;
  R_camera_design.row(0) = right;
  R_camera_design.row(1) = forward.cross(right);  // down
  R_camera_design.row(2) = forward;

  View view;
  const double tangent = std::tan(0.5 * fov_deg * std::numbers::pi / 180.0);
  view.camera.width = width;
  view.camera.height = height;
  view.camera.fx = view.camera.fy = 0.5 * std::min(width, height) / tangent;
  view.camera.cx = 0.5 * (width - 1);
  view.camera.cy = 0.5 * (height - 1);

  // The least distance at which every corner is inside the four side planes, 5 % kept as margin;
  // then the camera moves sideways until the corners stand centred, and nearer again: settled in a
  // few turns.
  const Eigen::Vector3d centre = box.center();
  const double tangent_x = 0.95 * 0.5 * width / view.camera.fx;
  const double tangent_y = 0.95 * 0.5 * height / view.camera.fy;
  const double radius = std::max(0.5 * box.diagonal().norm(), 1e-3);
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = R_camera_design * (box.corner(static_cast<CornerType>(i)) - centre);
  }
  Eigen::Vector2d aside = Eigen::Vector2d::Zero();  // m, of the camera
  double distance = 0;
  for (int turn = 0; turn < 10; ++turn) {
    distance = 1.05 * radius;
    for (const Eigen::Vector3d& p : corners) {
      distance = std::max({distance, std::abs(p.x() - aside.x()) / tangent_x - p.z(),
                           std::abs(p.y() - aside.y()) / tangent_y - p.z()});
    }
    if (turn == 9) break;
    Eigen::AlignedBox2d seen;  // as tangents of the angles from the axis
    for (const Eigen::Vector3d& p : corners) {
      seen.extend(Eigen::Vector2d((p.head<2>() - aside) / (p.z() + distance)));
    }
    aside += seen.center() * distance;
  }
  view.T_camera_design.linear() = R_camera_design;
  view.T_camera_design.translation() =
      Eigen::Vector3d(-aside.x(), -aside.y(), distance) - R_camera_design * centre;
  // What surrounds the box belongs to the picture too: a hand before it, the floor behind it.
  view.near_m = 0.05 * distance;
  view.far_m = distance + 20 * radius;
  return view;
}

Camera camera_in_picture(const Camera& camera, int width, int height) {
  assert(camera.is_valid() && width > 0 && height > 0 && "a camera and a picture");
  const double scale = std::min(static_cast<double>(width) / camera.width,
                                static_cast<double>(height) / camera.height);
  Camera result = camera;
  result.width = width;
  result.height = height;
  result.fx = camera.fx * scale;
  result.fy = camera.fy * scale;
  // Scaled about the corner of the picture, which lies half a pixel from the first pixel's centre.
  result.cx = (camera.cx + 0.5) * scale + 0.5 * (width - camera.width * scale) - 0.5;
  result.cy = (camera.cy + 0.5) * scale + 0.5 * (height - camera.height * scale) - 0.5;
  return result;
}

Projected project(const View& view, const Eigen::Vector3d& p_design) {
  const Eigen::Vector3d p_camera = view.T_camera_design * p_design;
  const Eigen::Vector2d pixel = view.camera.project(p_camera);
  return {pixel.x(), pixel.y(), p_camera.z()};
}

}  // namespace spool::render
