// Points as a sensor gave them, each with what it truly shows.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace spool::campaign {

struct SensedPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();  // m, scan frame
  std::uint16_t label = 0;
  std::uint8_t instance = 0;  // kNoInstance: clutter
  std::uint8_t station = 0;   // or frame
};

// How many points of which kind to take, all at one spacing where the clutter allows it.
struct PointTargets {
  std::size_t object = 0, clutter = 0;
  double density = 0;  // 1/m2, of a scene without an object to take it from; 0: as it comes
};

}  // namespace spool::campaign
