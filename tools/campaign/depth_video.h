// What a hand-held depth camera films, frame by frame, as a driver would deliver it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tools/campaign/hand_camera.h"
#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"

namespace spool::campaign {

// The intrinsics of the pixels that are cast, counts of a millimetre as OpenNI drivers give them.
[[nodiscard]] Camera camera_of(const HandheldSettings& settings);

// A block on a rope that swings about `pivot` (m, scan frame) in the plane of `direction` and z.
struct Hook {
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::UnitX();
  double rope_m = 0.8, swing_rad = 0.6, hertz = 0.5;
};
[[nodiscard]] std::vector<Placed> hook_at(const Hook& hook, double seconds);

// Frame `index`, `seconds` after the start, from `T_scan_camera`. `moving`: see read_frame().
[[nodiscard]] DepthFrame film(const RayWorld& world, const RayWorld* moving,
                              const HandheldSettings& settings, const Pose& T_scan_camera,
                              std::uint32_t seed, int index, double seconds);

}  // namespace spool::campaign
