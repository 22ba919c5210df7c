// A depth camera's pinhole intrinsics and what is known of its scale.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <Eigen/Core>

#include "vision/core/depth_warp.h"

namespace spool {

// What a gauge check or a calibration found. Without one, scale_u is half a percent (ARCHITECTURE,
// Files).
struct Calibration {
  std::string id;          // empty: uncalibrated
  std::string date;        // ISO 8601
  double scale_u = 0.005;  // standard uncertainty of the depth scale, as a fraction
  double warp_u_m = 0.0;   // m, standard uncertainty left at the image corners
  DepthWarp warp = {};     // taken off the depth in back_project()
};

// Pinhole without distortion. Camera frame: x right, y down, z forward; pixel centres at integer
// (u, v).
struct Camera {
  int width = 0;                // px
  int height = 0;               // px
  double fx = 0;                // px
  double fy = 0;                // px
  double cx = 0;                // px
  double cy = 0;                // px
  double depth_unit_m = 0.001;  // m for one count of depth
  Calibration calibration = {};

  // The point (m) seen at pixel (u, v) at depth z (m along the optical axis).
  [[nodiscard]] Eigen::Vector3d back_project(double u, double v, double z) const {
    return {(u - cx) * z / fx, (v - cy) * z / fy, z};
  }
  // The pixel of a point (m) in front of the camera.
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const {
    return {fx * p_camera.x() / p_camera.z() + cx, fy * p_camera.y() / p_camera.z() + cy};
  }
  // True for finite, positive intrinsics of an image of 1 to 16384 px a side.
  [[nodiscard]] bool is_valid() const {
    const auto good = [](double x) { return x > 0 && x < 1e9; };
    const auto finite = [](double x) { return x > -1e9 && x < 1e9; };
    return width > 0 && height > 0 && width <= 16384 && height <= 16384 && good(fx) && good(fy) &&
           finite(cx) && finite(cy) && good(depth_unit_m);
  }
};

}  // namespace spool
