// Steel that the design does not have: what sticks out of the spool and is held by it alone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/find/dominant_planes.h"

namespace spool {

struct Unexpected {
  int part = -1;                      // of the design, that it sticks out of
  double reach_m = 0;                 // as far as it gets from the design's surface
  std::vector<std::uint32_t> points;  // into left, ascending
};

// The scan as it is looked at; m, design frame.
struct UnexpectedScan {
  std::span<const Eigen::Vector3f> object;    // points on the design…
  std::span<const std::int32_t> object_part;  // …and the part each lies on
  std::span<const Eigen::Vector3f> left;      // what is neither that nor floor nor wall
  std::span<const DominantPlane> planes;      // floor, walls, tables
  double noise_m = 0.003;                     // of a point
};

// What of the rest is joined to the spool, point to point as dense as the scan is, and to nothing
// else: what reaches floor, wall or table holds the spool up or only stands beside it, and so does
// what touches a support that the design names.
[[nodiscard]] std::vector<Unexpected> unexpected_steel(const DesignModel& design,
                                                       const DesignSurface& surface,
                                                       const UnexpectedScan& scan,
                                                       const Watch& watch = {});

}  // namespace spool
