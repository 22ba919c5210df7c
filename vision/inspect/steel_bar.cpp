// A straight bar that grows out of the spool.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/steel_bar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "vision/core/point_cloud.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kFewest = 30;
constexpr int kNormalNeighbours = 12;
// Of the normals' scatter: what points along a bar, its end and noise, and what points aside in the
// lesser of two ways, for a side of it to have been seen and no plate.
constexpr float kMostAlong = 0.15F, kLeastAside = 0.05F;
constexpr float kLongerThanThick = 1.0F;
constexpr float kOutliers = 0.02F;  // share at either end of a range that does not count
constexpr float kFarthest = 1.0F;   // m
constexpr float kIntoSteel = 0.3F;  // of the bar's radius, that its line gets into the steel by…
constexpr int kFarthestSteel = 6;   // …so many radii on at most: a bar aslant begins far out

struct Range {
  float least = 0, most = 0;
  [[nodiscard]] float size() const { return most - least; }
};

Range range_along(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& direction) {
  std::vector<float> at(points.size());
  std::transform(points.begin(), points.end(), at.begin(),
                 [&](const Eigen::Vector3f& p) { return p.dot(direction); });
  std::sort(at.begin(), at.end());
  const auto skip = static_cast<std::size_t>(kOutliers * static_cast<float>(at.size()));
  return {at[skip], at[at.size() - 1 - skip]};
}

// The circle of least algebraic error (Kasa 1976) through the points on the plane of unit `x` and
// `y`: where the line of a round bar runs that was seen from one side. Unlike
// fit_cylinder() it needs no start.
struct Circle {
  Eigen::Vector3f middle;  // in the plane through the origin
  float radius;
};
std::optional<Circle> circle_across(const std::vector<Eigen::Vector3f>& points,
                                    const Eigen::Vector3f& x, const Eigen::Vector3f& y) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& p : points) mean += Eigen::Vector2d(p.dot(x), p.dot(y));
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector2d q = Eigen::Vector2d(p.dot(x), p.dot(y)) - mean;
    const Eigen::Vector3d row(2 * q.x(), 2 * q.y(), 1);
    normal += row * row.transpose();
    right += q.squaredNorm() * row;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::Vector3d fit = solver.solve(right);
  const double radius2 = fit.z() + fit.head<2>().squaredNorm();
  if (!(radius2 > 0)) return std::nullopt;
  const Eigen::Vector2f middle = (mean + fit.head<2>()).cast<float>();
  return Circle{middle.x() * x + middle.y() * y, static_cast<float>(std::sqrt(radius2))};
}

}  // namespace

std::optional<SteelBar> bar_out_of(const DesignSurface& surface,
                                   std::span<const Eigen::Vector3f> points) {
  if (points.size() < kFewest) return std::nullopt;
  PointCloud cloud;
  cloud.points.assign(points.begin(), points.end());
  estimate_neighbour_normals(cloud, PointIndex(cloud.points), kNormalNeighbours, std::nullopt);
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  float normals = 0;
  for (const Eigen::Vector3f& n : cloud.normals) {
    scatter.noalias() += n * n.transpose();
    normals += n.squaredNorm();
  }
  if (!(normals > 0)) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes(scatter / normals);
  if (axes.eigenvalues()[0] > kMostAlong || axes.eigenvalues()[1] < kLeastAside)
    return std::nullopt;

  SteelBar bar;
  bar.direction = axes.eigenvectors().col(0);
  const Range along = range_along(cloud.points, bar.direction);
  const std::optional<Circle> circle =
      circle_across(cloud.points, axes.eigenvectors().col(1), axes.eigenvectors().col(2));
  if (!circle || along.size() < 2 * kLongerThanThick * circle->radius) return std::nullopt;
  // The end at the spool is the one whose line goes on into it, and soonest.
  const auto on_line = [&](float at) -> Eigen::Vector3f {
    return circle->middle + at * axes.eigenvectors().col(0);
  };
  const auto part_at = [&](float at) {
    const auto nearest = surface.closest(on_line(at), kFarthest);
    return nearest && nearest->distance < -kIntoSteel * circle->radius ? nearest->part : -1;
  };
  bool begins_at_most = false;
  for (int step = 1; step <= kFarthestSteel && bar.part < 0; ++step) {
    const float by = static_cast<float>(step) * circle->radius;
    bar.part = part_at(along.least - by);
    begins_at_most = bar.part < 0;
    if (begins_at_most) bar.part = part_at(along.most + by);
  }
  if (bar.part < 0) return std::nullopt;  // it lies beside the steel, or off it
  bar.joined = on_line(begins_at_most ? along.most : along.least);
  if (begins_at_most) bar.direction = -bar.direction;
  bar.length_m = along.size();
  return bar;
}

}  // namespace spool
