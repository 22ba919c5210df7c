// What a structured-light camera of the PrimeSense class makes of each pixel of one frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/campaign/ray_world.h"

namespace spool::campaign {

// ARCHITECTURE, The sensor.
struct HandheldSettings {
  int width = 640, height = 480;  // px
  double focal_px = 575;
  double baseline_m = 0.075;  // the projector stands that far to the left
  double disparity_step_px = 0.125;
  double nearest_m = 0.4, farthest_m = 3.5;  // along the optical axis
  double distance_m = 0.85;                  // to what is looked at, 0.6 to 1.2 m along the way
  int frames = 36;
  int pixel_step = 3;  // every third pixel of every third row is cast

  [[nodiscard]] int columns() const { return (width + pixel_step - 1) / pixel_step; }
  [[nodiscard]] int rows() const { return (height + pixel_step - 1) / pixel_step; }
  // Camera frame, z = 1: where pixel (u, v) looks.
  [[nodiscard]] Eigen::Vector3d ray(double u, double v) const {
    return {(u - 0.5 * (width - 1)) / focal_px, (v - 0.5 * (height - 1)) / focal_px, 1};
  }
};

// The camera at `from` that looks at `to`, its x level; not straight up or down.
[[nodiscard]] Pose looking(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// What one pixel measured.
struct Reading {
  double z = 0;                    // m along the optical axis, in disparity steps; 0: nothing
  const Placed* placed = nullptr;  // what it shows, where z is not 0
};

// One frame's readings, row by row of the pixels that are cast. `moving` holds what does not stand
// still, where it is at that moment; null where all does. The same for the same seed and frame.
[[nodiscard]] std::vector<Reading> read_frame(const RayWorld& world, const RayWorld* moving,
                                              const HandheldSettings& settings,
                                              const Pose& T_scan_camera, std::uint32_t seed,
                                              int frame);

// Total standard deviation of depth (m) along the axis by range (m) and incidence (rad): Nguyen,
// Izadi & Lovell 2012, the part for grazing rays held at its value for 80 degrees.
[[nodiscard]] double axial_noise(double z, double incidence);

}  // namespace spool::campaign
