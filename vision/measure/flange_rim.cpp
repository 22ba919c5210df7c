// A flange's outside diameter by the points on its rim.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/flange_rim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "vision/core/median.h"
#include "vision/measure/part_shapes.h"
#include "vision/measure/patch_scatter.h"

namespace spool {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kLeastPoints = 30;
constexpr double kLeastFacing = 0.4;  // cosine, as of features
constexpr int kSectors = 12;

// Where along the face's normal the rim lies, from the port.
struct RimBand {
  double low_m = 0, high_m = 0;
};

std::optional<RimBand> rim_band(const DesignModel& design, const Part& part,
                                const FaceShape& shape) {
  RimBand band{1e9, -1e9};
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    Eigen::Matrix3d corners;
    bool is_rim = true;
    for (int k = 0; k < 3; ++k) {
      corners.col(k) = design.mesh.vertices[design.mesh.triangles[t][static_cast<std::size_t>(k)]]
                           .cast<double>() -
                       shape.point;
      const Vector3d d = corners.col(k);
      const double across = (d - d.dot(shape.normal) * shape.normal).norm();
      is_rim = is_rim && across > 0.995 * shape.flange_radius_m;
    }
    if (!is_rim) continue;
    for (int k = 0; k < 3; ++k) {
      band.low_m = std::min(band.low_m, corners.col(k).dot(shape.normal));
      band.high_m = std::max(band.high_m, corners.col(k).dot(shape.normal));
    }
  }
  constexpr double kLeastThickness_m = 0.005;
  if (!(band.high_m - band.low_m > kLeastThickness_m)) return std::nullopt;
  const double margin = (band.high_m - band.low_m) / 6;
  return RimBand{band.low_m + margin, band.high_m - margin};
}

std::vector<Vector3d> on_rim(const FeatureScan& scan, int part, const FaceShape& shape,
                             const RimBand& band, const Watch& watch) {
  std::vector<Vector3d> points;
  watched_loop(scan.scan_design.size(), watch, [&](std::size_t i) {
    if (scan.deviations.part[i] != part || scan.classes[i] == PointClass::kClutter) return;
    const Vector3d point = scan.scan_design.points[i].cast<double>();
    const Vector3d normal = scan.deviations.normal[i].cast<double>();
    if (!point.allFinite() || !(std::abs(normal.dot(shape.normal)) < 0.05)) return;
    if (scan.eye && (*scan.eye - point).normalized().dot(normal) < kLeastFacing) return;
    const Vector3d foot =
        point - static_cast<double>(scan.deviations.distance_m[i]) * normal - shape.point;
    const double along = foot.dot(shape.normal);
    const double across = (foot - along * shape.normal).norm();
    if (along > band.low_m && along < band.high_m && across > 0.99 * shape.flange_radius_m)
      points.push_back(point);
  });
  return points;
}

struct Circle {
  Vector2d centre = Vector2d::Zero();
  double radius_m = 0, sigma_m = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // centre, radius
  bool is_determined = false;

  [[nodiscard]] double distance(const Vector2d& p) const { return (p - centre).norm() - radius_m; }
};

// Least squares of the distances under Tukey's weights, by Gauss-Newton.
Circle fit_circle(const std::vector<Vector2d>& points, double radius_m) {
  Circle circle;
  circle.radius_m = radius_m;
  constexpr int kRounds = 30;
  constexpr double kTukey = 4.685;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> off;
    for (const Vector2d& p : points) off.push_back(std::abs(circle.distance(p)));
    circle.sigma_m = 1.4826 * median(off);
    if (!(circle.sigma_m > 0)) circle.sigma_m = 1e-6;  // exact points
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Vector2d& p : points) {
      const double residual = circle.distance(p), share = residual / (kTukey * circle.sigma_m);
      if (std::abs(share) >= 1) continue;
      const double weight = std::pow(1 - share * share, 2);
      const Vector2d out = (p - circle.centre).normalized();
      const Vector3d gradient(out.x(), out.y(), 1);
      normal += weight * gradient * gradient.transpose();
      right += weight * residual * gradient;
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-6)) return {};
    const Vector3d step = solver.solve(right);
    circle.centre += step.head<2>();
    circle.radius_m += step[2];
    circle.covariance = circle.sigma_m * circle.sigma_m * solver.solve(Eigen::Matrix3d::Identity());
    if (step.norm() < 1e-7) break;
  }
  circle.is_determined = circle.radius_m > 0.5 * radius_m && circle.radius_m < 2 * radius_m;
  return circle;
}

}  // namespace

std::optional<FlangeRim> measure_rim(const DesignModel& design, const FeatureScan& scan,
                                     const PartFeatures& features, int index, const Watch& watch) {
  const Part& part = design.parts[static_cast<std::size_t>(index)];
  const auto shape = face_shape(design, index);
  if (!shape) return std::nullopt;
  const auto band = rim_band(design, part, *shape);
  if (!band) return std::nullopt;
  const std::vector<Vector3d> points = on_rim(scan, index, *shape, *band, watch);
  if (points.size() < kLeastPoints) return std::nullopt;
  const int face = features.of(index);
  const Vector3d normal =
      face < 0
          ? shape->normal
          : Vector3d(
                features.features[static_cast<std::size_t>(face)].T_design_measured.linear().col(
                    2));
  const Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vector2d> flat;
  for (const Vector3d& p : points)
    flat.emplace_back((p - shape->point).dot(x), (p - shape->point).dot(y));
  const Circle circle = fit_circle(flat, shape->flange_radius_m);
  if (!circle.is_determined) return std::nullopt;
  PatchScatter scatter;
  for (const Vector2d& p : flat) {
    if (std::abs(circle.distance(p)) > 3 * circle.sigma_m) continue;
    const Vector2d d = p - circle.centre;
    const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 0.5;
    scatter.add(std::min(kSectors - 1, static_cast<int>(kSectors * turn)), circle.distance(p));
  }
  scatter.finish(3, scan.correlated);
  // Merged stations are off against each other: most of the way round has to be seen. One camera
  // sees half of it at best.
  const std::size_t least = scan.eye ? kSectors / 4 : 2 * kSectors / 3;
  if (scatter.patches() < least) return std::nullopt;
  FlangeRim rim;
  rim.nominal_m = 2 * shape->flange_radius_m;
  rim.diameter_m = 2 * circle.radius_m;
  // Opposite sides are off apart from each other, about as much as one is.
  rim.u_m = std::hypot(2 * std::sqrt(scan.correlated * scatter.birge() * circle.covariance(2, 2)),
                       features.patch_error_m);
  rim.centre = shape->point + circle.centre.x() * x + circle.centre.y() * y;
  return rim;
}

}  // namespace spool
