// Puts the object down, any side up, on floor, stands or a table, with scanner stations round it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/campaign/labels.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;
constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace

Pose laid_down(const Assembly& assembly, double height, bool level, Random& random) {
  const Eigen::AlignedBox3d box = bounds_of(assembly);
  int down = 0;
  box.sizes().minCoeff(&down);
  if (random.chance(0.4)) down = random.below(3);
  Vector3d axis = Vector3d::Zero();
  axis[down] = random.chance(0.5) ? 1 : -1;
  Pose pose(Eigen::Quaterniond::FromTwoVectors(axis, -Vector3d::UnitZ()));
  const Vector3d lean(random.uniform(-1, 1), random.uniform(-1, 1), 0);
  if (!level) pose.prerotate(Eigen::AngleAxisd(0.05 * random.uniform(), lean.stableNormalized()));
  pose.prerotate(Eigen::AngleAxisd(random.uniform(0, kTurn), Vector3d::UnitZ()));
  // The lowest of the surface comes to lie at `height`, the box's middle over the origin.
  const Vector3d middle = pose * box.center();
  pose.pretranslate(Vector3d(-middle.x(), -middle.y(), height - lowest_of(assembly, pose)));
  return pose;
}

double lowest_of(const Assembly& assembly, const Pose& T_scan_design) {
  const std::vector<Pose> poses = poses_of(assembly);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (assembly.members[i].missing) continue;
    for (const Patch& patch : patches_of(assembly.members[i].spec)) {
      Random samples(i, 77);
      const Pose T = T_scan_design * poses[i] * patch.T_part_patch;
      for (int k = 0; k < 200; ++k)
        if (const auto point = sample(patch, samples)) lowest = std::min(lowest, (T * *point).z());
    }
  }
  return lowest;
}

void add_stands(const std::vector<Placed>& object, Random& random, Room& room) {
  const RayWorld world(object);
  constexpr double kHalf = 0.05;
  // The height of the object's underside over a stand's footprint; 0 where there is none over its
  // middle.
  const auto underside = [&](double x, double y) {
    double lowest = 0;
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) {
        const auto hit =
            world.cast({x + 0.5 * i * kHalf, y + 0.5 * j * kHalf, 0}, Vector3d::UnitZ(), 10);
        if (i == 0 && j == 0 && !hit) return 0.0;
        if (hit) lowest = lowest == 0 ? hit->distance : std::min(lowest, hit->distance);
      }
    return lowest;
  };
  std::vector<Vector3d> tops;
  for (int tries = 0; tries < 400 && tops.size() < 60; ++tries) {
    const Placed& placed =
        object[static_cast<std::size_t>(random.below(static_cast<int>(object.size())))];
    const auto local = sample(placed.patch, random);
    if (!local) continue;
    const Vector3d point = placed.T_scan_patch * *local;
    const double top = underside(point.x(), point.y());
    if (top > 0.05) tops.emplace_back(point.x(), point.y(), top - 0.002);
  }
  std::vector<Vector3d> chosen;
  while (chosen.size() < 3 && !tops.empty()) {
    // The farthest from those that stand already; the first one the lowest.
    const auto worth = [&](const Vector3d& p) {
      if (chosen.empty()) return -p.z();
      double nearest = 1e9;
      for (const Vector3d& other : chosen)
        nearest = std::min(nearest, (p - other).head<2>().norm());
      return nearest;
    };
    const auto best = std::max_element(tops.begin(), tops.end(), [&](const auto& a, const auto& b) {
      return worth(a) < worth(b);
    });
    if (!chosen.empty() && worth(*best) < 0.25) break;
    chosen.push_back(*best);
    tops.erase(best);
  }
  for (const Vector3d& top : chosen) {
    const Vector3d half(kHalf, kHalf, top.z() / 2);
    const Vector3d middle(top.x(), top.y(), top.z() / 2);
    add_block(middle, half, 0, kStand, room);
    room.taken.emplace_back(middle - half, middle + half);
  }
}

std::vector<Vector3d> stations_round(const Eigen::AlignedBox3d& object, int count, Random& random,
                                     Room& room) {
  std::vector<Vector3d> stations;
  const Vector3d middle = object.center();
  const Vector3d half = object.sizes() / 2;
  const double first = random.uniform(0, kTurn);
  for (int i = 0; i < count; ++i) {
    const double angle = first + kTurn * (i + random.uniform(-0.15, 0.15)) / count;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    // From the object's box outwards.
    double edge = 1e9;
    for (int k = 0; k < 2; ++k)
      if (std::abs(out[k]) > 1e-6) edge = std::min(edge, half[k] / std::abs(out[k]));
    Vector3d place = middle + (edge + random.uniform(1.2, 2.0)) * out;
    place.z() = random.uniform(1.2, 1.8);
    stations.push_back(place);
    const Vector3d room_for(0.35, 0.35, 0);
    const Vector3d foot(place.x(), place.y(), 0);
    room.taken.emplace_back(foot - room_for, place + room_for + Vector3d(0, 0, 0.3));
    room.half_x = std::max(room.half_x, std::abs(place.x()) + 0.6);
    room.half_y = std::max(room.half_y, std::abs(place.y()) + 0.6);
  }
  return stations;
}

}  // namespace spool::campaign
