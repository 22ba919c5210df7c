// Where the simulated camera is at a time.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/simulator/scene.h"
#include "vision/core/pose.h"

namespace spool::simulator {

// T_map_camera at `seconds`: a smooth function of time and the seed, without end. Hand-held: swings
// about `centre` (m, map frame) with changing distance and height, looking at it, with a tremor of
// 0.4 to 4 Hz whose amplitude falls with frequency.
[[nodiscard]] Pose camera_pose(const Trajectory& trajectory, const Eigen::Vector3d& centre,
                               double seconds);

}  // namespace spool::simulator
