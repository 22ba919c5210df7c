// A structured-light camera carried round the object: frames merged by
// their true poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/hand_camera.h"
#include "tools/campaign/sensed.h"

namespace spool::campaign {

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

}  // namespace spool::campaign
