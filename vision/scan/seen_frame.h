// One depth image as the map and the tracker take it: points, normals, and what made them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/camera.h"
#include "vision/core/point_cloud.h"
#include "vision/scan/noise_model.h"

namespace spool {

// The organised cloud of `camera` in the camera frame (m), with normals
// (estimate_organised_normals: zero where there is none), borrowed; it must outlive the frame.
struct SeenFrame {
  const PointCloud& cloud;
  Camera camera;
  NoiseModel noise;
  double seconds = 0;  // s on the source's own clock

  [[nodiscard]] bool is_usable() const {
    return camera.is_valid() && cloud.width == camera.width && cloud.height == camera.height &&
           cloud.is_consistent() && cloud.has_normals();
  }
};

}  // namespace spool
