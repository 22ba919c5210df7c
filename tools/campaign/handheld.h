// A structured-light camera of the PrimeSense class, carried round the object: frames merged by
// their true poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/ray_world.h"
#include "tools/campaign/sensed.h"

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
};

// Camera frame: x right, y down, z forward. A walk round the object in two rounds, one lower and
// one higher, with a hand's unsteadiness; nowhere is a wall or a box between the camera and what it
// looks at.
[[nodiscard]] std::vector<Pose> walk_round(const RayWorld& world, const HandheldSettings& settings,
                                           const Eigen::AlignedBox3d& object, std::uint32_t seed);

// All measured points of all frames; `station` is the frame.
[[nodiscard]] std::vector<SensedPoint> scan_by_hand(const RayWorld& world,
                                                    const HandheldSettings& settings,
                                                    const std::vector<Pose>& T_scan_camera,
                                                    std::uint32_t seed);

// Total standard deviation of depth (m) along the axis by range (m) and incidence (rad): Nguyen,
// Izadi & Lovell 2012, the part for grazing rays held at its value for 80 degrees.
[[nodiscard]] double axial_noise(double z, double incidence);

}  // namespace spool::campaign
