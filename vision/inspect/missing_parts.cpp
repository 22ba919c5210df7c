// Parts of which nothing shows although what they are joined to does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/missing_parts.h"

#include <algorithm>

#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr double kNothing = 0.05;       // of the part's own surface
constexpr double kWell = 0.35;          // of what it is joined to
constexpr std::size_t kFewSamples = 8;  // of its own surface: then all of it is looked at

// What it is joined to shows well, and there is something.
bool is_seen_all_round(const DesignModel& design, int part,
                       const std::vector<PartDeviation>& parts) {
  bool has_neighbour = false;
  for (const Joint& joint : design.joints) {
    if (joint.part_a != part && joint.part_b != part) continue;
    const int other = joint.part_a == part ? joint.part_b : joint.part_a;
    has_neighbour = true;
    if (parts[static_cast<std::size_t>(other)].coverage < kWell) return false;
  }
  return has_neighbour;
}

}  // namespace

std::vector<int> missing_parts(const DesignModel& design, const CloudView& scan_design,
                               std::span<const PointClass> classes, const SurfaceSamples& samples,
                               const std::vector<PartDeviation>& parts, const Watch& watch) {
  std::vector<int> missing;
  std::vector<int> doubtful;
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].coverage < kWell && is_seen_all_round(design, static_cast<int>(p), parts))
      doubtful.push_back(static_cast<int>(p));
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < classes.size() && !doubtful.empty(); ++i)
    if (classes[i] == PointClass::kObject) points.push_back(scan_design.points[i]);
  if (points.empty()) return missing;
  const PointIndex scan(points, watch);
  const PointIndex surface(samples.cloud.points, watch);
  if (watch.cancelled()) return missing;
  const auto near = static_cast<float>(vouching_radius(scan, points, samples.radius_m));
  std::vector<Neighbour> neighbours;
  for (const int part : doubtful) {
    std::size_t own = 0, own_shown = 0, all = 0, all_shown = 0;
    for (std::size_t s = 0; s < samples.part.size(); ++s) {
      if (samples.part[s] != part) continue;
      const bool is_shown = scan.nearest(samples.cloud.points[s], near).has_value();
      ++all;
      all_shown += is_shown ? 1U : 0U;
      surface.within(samples.cloud.points[s], 2 * near, neighbours);
      if (std::any_of(neighbours.begin(), neighbours.end(),
                      [&](const Neighbour& n) { return samples.part[n.index] != part; }))
        continue;
      ++own;
      own_shown += is_shown ? 1U : 0U;
    }
    const bool is_enough = own >= kFewSamples;
    const auto shown = static_cast<double>(is_enough ? own_shown : all_shown);
    if (shown <= kNothing * static_cast<double>(is_enough ? own : all)) missing.push_back(part);
  }
  return missing;
}

}  // namespace spool
