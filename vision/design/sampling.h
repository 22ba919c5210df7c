// Points spread evenly over the design surface (Poisson disk; Corsini, Cignoni & Scopigno 2012).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/point_cloud.h"
#include "vision/design/design_model.h"

namespace spool {

struct SurfaceSamples {
  PointCloud cloud;                // with outward normals, design frame
  std::vector<std::int32_t> part;  // of each point
  double radius_m = 0;             // no two points are closer
};

// About `count` samples (within 15 %), no two closer than radius_m, on the design's surface; every
// point of the surface within 2 * radius_m of one. Same seed, same samples. For a cloud design, its
// own points thinned the same way, all of them (and a radius of 0) where there are no more than
// asked for. Cancelled: some samples or none.
[[nodiscard]] SurfaceSamples sample_surface(const DesignModel& design, std::size_t count,
                                            std::uint32_t seed = 1, const Watch& watch = {});

}  // namespace spool
