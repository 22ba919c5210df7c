// The way of a hand-held camera round the object.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/campaign/handheld.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;

// Points all over the object's surface, in the order of their direction from its middle.
std::vector<Vector3d> points_round(const RayWorld& world, const Vector3d& middle, Random& random) {
  std::vector<Vector3d> points;
  for (const Placed& placed : world.placed()) {
    if (placed.instance == kNoInstance || placed.patch.inward) continue;
    const int count = 1 + static_cast<int>(300 * sampled_area(placed.patch));
    for (int i = 0; i < count; ++i)
      if (const auto point = sample(placed.patch, random))
        points.push_back(placed.T_scan_patch * *point);
  }
  const auto angle = [&](const Vector3d& p) {
    return std::atan2(p.y() - middle.y(), p.x() - middle.x());
  };
  std::sort(points.begin(), points.end(),
            [&](const Vector3d& a, const Vector3d& b) { return angle(a) < angle(b); });
  return points;
}

}  // namespace

std::vector<Pose> walk_round(const RayWorld& world, const HandheldSettings& settings,
                             const Eigen::AlignedBox3d& object, std::uint32_t seed) {
  Random random(seed, 301);
  const Vector3d middle = object.center();
  const std::vector<Vector3d> targets = points_round(world, middle, random);
  std::vector<Pose> poses;
  for (int i = 0; i < settings.frames; ++i) {
    const double way = 2.0 * i / settings.frames;  // in rounds
    Vector3d target = middle;
    if (!targets.empty()) {
      const double place = (way - std::floor(way)) * static_cast<double>(targets.size());
      target = targets[std::min(static_cast<std::size_t>(place), targets.size() - 1)];
    }
    Vector3d out = target - middle;
    if (out.head<2>().norm() < 1e-3)
      out = Vector3d(std::cos(kTurn * way), std::sin(kTurn * way), 0);
    out.z() = 0;
    out.normalize();
    // Higher where something stands in the way, in the end right above.
    double elevation = (way < 1 ? 0.35 : 0.85) + random.uniform(-0.1, 0.1);
    const double distance = settings.distance_m * random.uniform(0.75, 1.35);
    Vector3d eye = target;
    for (;; elevation += 0.15) {
      elevation = std::min(elevation, 1.5);
      const double spread = random.uniform(-0.4, 0.4);
      const Vector3d towards = Eigen::AngleAxisd(spread, Vector3d::UnitZ()) * out;
      eye =
          target + distance * (std::cos(elevation) * towards + Vector3d(0, 0, std::sin(elevation)));
      // From a little off the target, which lies on a surface itself.
      const Vector3d start = target + 0.05 * (eye - target).normalized();
      if (elevation >= 1.5 || (eye.z() > 0.2 && !world.blocked(eye, start))) break;
    }
    poses.push_back(looking(eye, target));
    poses.back().rotate(Eigen::AngleAxisd(0.1 * random.normal(), Vector3d::UnitZ()));
  }
  return poses;
}

}  // namespace spool::campaign
