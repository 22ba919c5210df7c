// The plane that things stand on where the floor itself is not in the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "vision/find/dominant_planes.h"

namespace spool {

// Floors are cut off scans, or were too far from the scanner. What stood on one still ends where it
// was: in a plane with next to nothing of all `points` behind it, at many places far apart.
// `witnesses`: the points whose ends count. m, finite; `down`: unit, to some 25 degrees; `size_m`:
// of the design; `band_m`: so near the plane a point counts as on it. Nothing where no such plane
// shows. Its normal points up, its patch is where witnesses end.
[[nodiscard]] std::optional<DominantPlane> ground(std::span<const Eigen::Vector3f> points,
                                                  std::span<const Eigen::Vector3f> witnesses,
                                                  const Eigen::Vector3f& down, double size_m,
                                                  double band_m);

}  // namespace spool
