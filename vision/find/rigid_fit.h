// The rigid motion of least squares between points and points, bare and quick.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "vision/core/pose.h"

namespace spool {

// T_to_from with the least sum of squares of to[i] - T * from[i] (Umeyama 1991 without scale;
// proper rotations only). As many of both, three or more (m). Where they lie on a line the turn
// about it is arbitrary. For picks that have to be doubted: align_pairs()
// (vision/align/three_point.h).
[[nodiscard]] Pose fit_rigid_motion(std::span<const Eigen::Vector3d> from,
                                    std::span<const Eigen::Vector3d> to);

}  // namespace spool
