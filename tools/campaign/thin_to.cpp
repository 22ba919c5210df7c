// From many points to as many as asked for, at one spacing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/thin_to.h"

#include <algorithm>
#include <utility>

#include "tools/campaign/point_spacing.h"
#include "tools/campaign/ray_world.h"

namespace spool::campaign {
namespace {

std::vector<SensedPoint> thinned(const std::vector<SensedPoint>& points, double spacing_m) {
  PointSpacing spacing(spacing_m, points.size());
  std::vector<SensedPoint> kept;
  for (const SensedPoint& each : points) {
    if (!spacing.has_room(each.point)) continue;
    spacing.add(each.point);
    kept.push_back(each);
  }
  return kept;
}

// The widest spacing (m), to about one part in two hundred, that leaves `target` points or more.
double spacing_that_leaves(std::size_t target, const std::vector<SensedPoint>& points) {
  double low = 1e-4;
  double high = 0.5;
  while (high / low > 1.005) {
    const double middle = std::sqrt(low * high);
    (thinned(points, middle).size() >= target ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<SensedPoint> thinned_to(const std::vector<SensedPoint>& points,
                                    const PointTargets& targets, const Eigen::AlignedBox3d& object,
                                    Random random) {
  std::vector<SensedPoint> shuffled = points;
  for (std::size_t i = shuffled.size(); i > 1; --i)
    std::swap(shuffled[i - 1], shuffled[static_cast<std::size_t>(random.bits() % i)]);
  const auto split =
      std::stable_partition(shuffled.begin(), shuffled.end(),
                            [](const SensedPoint& each) { return each.instance != kNoInstance; });
  const std::vector<SensedPoint> of_object(shuffled.begin(), split);
  const std::vector<SensedPoint> of_clutter(split, shuffled.end());
  std::vector<SensedPoint> kept;
  double spacing_m = 0.5;
  if (targets.object > 0) {
    spacing_m = spacing_that_leaves(targets.object, of_object);
    kept = thinned(of_object, spacing_m);
    kept.resize(std::min(kept.size(), targets.object));
  }
  std::vector<SensedPoint> clutter = thinned(of_clutter, spacing_m);
  if (clutter.size() < targets.clutter)
    clutter = thinned(of_clutter, spacing_that_leaves(targets.clutter, of_clutter));
  if (clutter.size() > targets.clutter) {
    const auto distance = [&](const SensedPoint& each) {
      return object.exteriorDistance(each.point.cast<double>());
    };
    std::nth_element(
        clutter.begin(), clutter.begin() + static_cast<long>(targets.clutter), clutter.end(),
        [&](const SensedPoint& a, const SensedPoint& b) { return distance(a) < distance(b); });
    clutter.resize(targets.clutter);
  }
  kept.insert(kept.end(), clutter.begin(), clutter.end());
  return kept;
}

}  // namespace spool::campaign
