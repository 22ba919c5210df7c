// Takes whole pieces of the object out of a scan, as if they had not been seen (thesis 4.4.2.3).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/removal.h"

#include <algorithm>
#include <cmath>

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

Vector3d middle_of(const PartSpec& spec) {
  Vector3d sum = Vector3d::Zero();
  const auto ports = ports_of(spec);
  for (const PartPort& port : ports) sum += port.T_part_port.translation();
  return sum / static_cast<double>(ports.size());
}

// How far each part lies from `end` along the joints (m), middle to middle.
std::vector<double> along_joints(const Assembly& assembly, const std::vector<Pose>& poses,
                                 std::size_t end) {
  const std::size_t count = assembly.members.size();
  std::vector<Vector3d> middles;
  for (std::size_t i = 0; i < count; ++i)
    middles.push_back(poses[i] * middle_of(assembly.members[i].spec));
  std::vector<double> distance(count, 1e9);
  distance[end] = 0;
  // A tree: as many rounds as it is deep settle it.
  for (std::size_t round = 0; round < count; ++round)
    for (std::size_t i = 0; i < count; ++i) {
      if (assembly.members[i].parent < 0) continue;
      const auto parent = static_cast<std::size_t>(assembly.members[i].parent);
      const double step = (middles[i] - middles[parent]).norm();
      distance[i] = std::min(distance[i], distance[parent] + step);
      distance[parent] = std::min(distance[parent], distance[i] + step);
    }
  return distance;
}

}  // namespace

double remove_pieces(const Scene& scene, double completeness, Random random,
                     std::vector<SensedPoint>& points) {
  if (completeness >= 1 || scene.objects.empty()) return 1;
  const std::vector<std::size_t> ends = ends_of(scene.as_built);
  std::size_t before = 0;
  std::size_t removed = 0;
  for (std::size_t object = 0; object < scene.objects.size(); ++object) {
    const Instance& instance = scene.objects[object];
    const bool branch = !ends.empty() && random.chance(0.5);
    std::vector<double> parts(scene.as_built.members.size(), 0);
    if (branch) {
      const std::size_t end =
          ends[static_cast<std::size_t>(random.below(static_cast<int>(ends.size())))];
      parts = along_joints(scene.as_built, instance.T_scan_part, end);
    }
    // A whole part after another, and within a part from its near end on: the order of going.
    const Vector3d side = random.direction();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].instance != object) continue;
      const double along = side.dot(points[i].point.cast<double>());
      order.emplace_back(branch ? parts[points[i].label] + 1e-6 * along : along, i);
    }
    before += order.size();
    std::sort(order.begin(), order.end());
    const auto gone = static_cast<std::size_t>(
        std::lround((1 - completeness) * static_cast<double>(order.size())));
    for (std::size_t k = 0; k < gone; ++k) points[order[k].second].label = 0xFFFF;
    removed += gone;
  }
  std::erase_if(points, [](const SensedPoint& each) { return each.label == 0xFFFF; });
  return before == 0 ? 1 : static_cast<double>(before - removed) / static_cast<double>(before);
}

}  // namespace spool::campaign
