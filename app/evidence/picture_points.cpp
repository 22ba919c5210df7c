// Which points of an inspection a picture shows, and how far they lie apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/picture_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "vision/scan/point_index.h"

namespace spool::evidence {
namespace {

constexpr auto kContradicting = static_cast<std::uint8_t>(PointClass::kContradicting);
constexpr double kCell = 1.5;  // of the points' spacing, where the nearest of them is
// Cells: as far as one of a slanting surface's points may lie behind its neighbours.
constexpr double kBehind = 3;

// The contradicting points as one sees them from a place: how far off in each direction.
class Curtain {
 public:
  Curtain(const PicturePoints& all, const Eigen::Vector3f& eye, double spacing_m)
      : eye_(eye), behind_m_(static_cast<float>(kBehind * kCell * spacing_m)) {
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < all.positions.size(); ++i)
      if (all.classes[i] == kContradicting)
        nearest = std::min(nearest, (all.positions[i] - eye).norm());
    cells_per_unit_ = nearest / std::max(static_cast<float>(kCell * spacing_m), 1e-3F * nearest);
    for (std::size_t i = 0; i < all.positions.size(); ++i)
      if (all.classes[i] == kContradicting) hang(all.positions[i]);
  }

  // Whether contradicting steel lies behind `point`, seen from there.
  [[nodiscard]] bool is_behind(const Eigen::Vector3f& point) const {
    if (far_m_.empty()) return false;
    const auto at = far_m_.find(cell_of(point));
    return at != far_m_.end() && (point - eye_).norm() + behind_m_ < at->second;
  }

 private:
  using Cell = std::array<int, 3>;

  [[nodiscard]] Cell cell_of(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f on_sphere = cells_per_unit_ * (point - eye_).normalized();
    return {static_cast<int>(std::floor(on_sphere.x())),
            static_cast<int>(std::floor(on_sphere.y())),
            static_cast<int>(std::floor(on_sphere.z()))};
  }
  // In its cell and those round it: points are no surface, and what lies between them is hidden.
  void hang(const Eigen::Vector3f& point) {
    const Cell middle = cell_of(point);
    const float distance = (point - eye_).norm();
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          float& far = far_m_[{middle[0] + x, middle[1] + y, middle[2] + z}];
          far = std::max(far, distance);
        }
  }

  Eigen::Vector3f eye_;
  float behind_m_;
  float cells_per_unit_ = 1;
  std::map<Cell, float> far_m_;
};

}  // namespace

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

Eigen::AlignedBox3d steel_bounds(const PicturePoints& points, const Eigen::AlignedBox3d& design) {
  Eigen::AlignedBox3d bounds = design;
  for (std::size_t i = 0; i < points.positions.size(); ++i)
    if (points.classes[i] == kContradicting) bounds.extend(points.positions[i].cast<double>());
  return bounds;
}

PicturePoints without_hiding_clutter(const PicturePoints& all, const DesignSurface& surface,
                                     const Eigen::Vector3d& eye, float reach_m, double spacing_m) {
  const Eigen::Vector3f from = eye.cast<float>();
  const Curtain contradicting(all, from, spacing_m);
  const auto hides = [&](std::size_t i) {
    return all.classes[i] == static_cast<std::uint8_t>(PointClass::kClutter) &&
           (contradicting.is_behind(all.positions[i]) ||
            surface.cast(all.positions[i], (all.positions[i] - from).normalized(), reach_m)
                .has_value());
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
