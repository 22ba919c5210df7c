// Floor and walls that end the scan: what lies behind them nobody can have seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/outer_planes.h"

#include <algorithm>

namespace spool {
namespace {

// Of the scan: mirrored readings and fringes of edges get behind a wall. What goes through it, or a
// room beyond a door, is more.
constexpr double kMostBehind = 0.003;

}  // namespace

std::vector<DominantPlane> outer_planes(std::span<const Eigen::Vector3f> points,
                                        std::span<const DominantPlane> planes, double band_m) {
  const auto band = static_cast<float>(band_m);
  std::vector<DominantPlane> outer;
  for (const DominantPlane& plane : planes) {
    std::size_t before = 0, behind = 0;
    for (const Eigen::Vector3f& point : points) {
      const float distance = plane.distance(point);
      before += distance > band ? 1U : 0U;
      behind += distance < -band ? 1U : 0U;
    }
    if (static_cast<double>(std::min(before, behind)) >
        kMostBehind * static_cast<double>(points.size()))
      continue;
    outer.push_back(plane);
    if (before >= behind) continue;
    outer.back().normal = -plane.normal;
    outer.back().offset = -plane.offset;
  }
  return outer;
}

bool is_behind(std::span<const DominantPlane> outer, const Eigen::Vector3f& place, double band_m) {
  return std::any_of(outer.begin(), outer.end(), [&](const DominantPlane& plane) {
    const float distance = plane.distance(place);
    return distance < -static_cast<float>(band_m) &&
           plane.patch.is_near(place - distance * plane.normal);
  });
}

}  // namespace spool
