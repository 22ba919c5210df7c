// Which points of an inspection a picture shows, and how far they lie apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/picture_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/scan/point_index.h"

namespace spool::evidence {

PicturePoints points_near_design(const Inspection& inspection, const Eigen::AlignedBox3d& bounds) {
  Eigen::AlignedBox3d near = bounds;
  const double margin = 0.15 * bounds.diagonal().norm();
  near.extend(bounds.min() - Eigen::Vector3d::Constant(margin));
  near.extend(bounds.max() + Eigen::Vector3d::Constant(margin));
  const auto& points = inspection.scan_design.points;
  const auto& classes = inspection.declutter.classes;
  PicturePoints drawn;
  if (classes.size() != points.size() || inspection.deviations.distance_m.size() != points.size())
    return drawn;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    if (classes[i] == PointClass::kClutter && !near.contains(points[i].cast<double>())) continue;
    drawn.positions.push_back(points[i]);
    drawn.deviation_m.push_back(inspection.deviations.distance_m[i]);
    drawn.classes.push_back(static_cast<std::uint8_t>(classes[i]));
  }
  return drawn;
}

PicturePoints without_hiding_clutter(const PicturePoints& all, const DesignSurface& surface,
                                     const Eigen::Vector3d& eye, float reach_m) {
  const Eigen::Vector3f from = eye.cast<float>();
  const auto hides = [&](std::size_t i) {
    return all.classes[i] == static_cast<std::uint8_t>(PointClass::kClutter) &&
           surface.cast(all.positions[i], (all.positions[i] - from).normalized(), reach_m)
               .has_value();
  };
  PicturePoints kept;
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    if (hides(i)) continue;
    kept.positions.push_back(all.positions[i]);
    kept.deviation_m.push_back(all.deviation_m[i]);
    kept.classes.push_back(all.classes[i]);
  }
  return kept;
}

double object_spacing(const PicturePoints& points) {
  constexpr std::size_t kPlaces = 500;
  constexpr std::size_t kNeighbours = 5;  // the point itself is the first
  constexpr float kReach_m = 0.1F;        // wider apart, no point size makes a surface of them
  std::vector<Eigen::Vector3f> object;
  for (std::size_t i = 0; i < points.positions.size(); ++i)
    if (points.classes[i] != 0) object.push_back(points.positions[i]);
  const PointIndex index(object);
  std::vector<float> distances;
  std::vector<Neighbour> neighbours;
  const std::size_t step = std::max<std::size_t>(1, object.size() / kPlaces);
  for (std::size_t i = 0; i < object.size(); i += step) {
    index.nearest_k(object[i], kNeighbours, kReach_m, neighbours);
    if (neighbours.size() == kNeighbours) distances.push_back(neighbours.back().distance);
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return static_cast<double>(*middle) * std::sqrt(std::numbers::pi / 4);
}

}  // namespace spool::evidence
