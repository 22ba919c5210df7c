// Floor, walls, table tops: planes larger than the design, found so that they can be set aside.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/find/occupancy.h"

namespace spool {

struct DominantPlane {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  // unit; its sign means nothing
  float offset = 0;                                   // m; normal.dot(p) = offset on the plane
  std::size_t points = 0;                             // of those it was found in
  Occupancy patch;                                    // where along the plane the scan lies on it

  // Within `band` (m) of the plane, where the scan showed it: a table ends where it ends.
  [[nodiscard]] bool holds(const Eigen::Vector3f& p, float band) const {
    return std::abs(distance(p)) <= band && patch.is_near(p);
  }
  [[nodiscard]] float distance(const Eigen::Vector3f& p) const { return normal.dot(p) - offset; }
};

struct DominantPlaneOptions {
  double size_m = 1.0;     // m; the design's diameter: no face of it is longer
  double noise_m = 0.003;  // m; standard deviation of a point
  int max_planes = 12;     // a room has six, a hall with tables a few more
  std::uint32_t seed = 1;
};

// Planes on which a connected patch of the scan is longer than the design and at least half as
// wide: no face of the design can be one of them. The largest first. Points (m) are finite.
[[nodiscard]] std::vector<DominantPlane> dominant_planes(std::span<const Eigen::Vector3f> points,
                                                         const DominantPlaneOptions& options,
                                                         const Watch& watch = {});

// Those of `points` further than `band_m` (m) from every plane, in order.
[[nodiscard]] std::vector<Eigen::Vector3f> off_planes(std::span<const Eigen::Vector3f> points,
                                                      std::span<const DominantPlane> planes,
                                                      double band_m);

}  // namespace spool
