// Planes in one depth image against what the sensor's calibration says of its warp.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/warp_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "vision/core/median.h"
#include "vision/find/dominant_planes.h"
#include "vision/measure/flat_warp.h"

namespace spool {
namespace {

constexpr std::size_t kMostSearched = 40'000;  // points that planes are looked for in
constexpr double kChiSquare3 = 11.345;         // of three degrees of freedom, beyond it 0.01
constexpr int kSquares = 3;                    // the terms fitted: x², xy, y²

// What a floor is off being flat over the width of a picture, as a standard deviation: a trowelled
// floor is within 3 to 5 mm under a straight edge of 3 m; estimated for about a metre.
constexpr double kFlatness_u_m = 0.0008;

// The picture's half sides, as far as readings lie (x / z, y / z).
Eigen::Vector2d half_sides(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& p : points)
    half = half.cwiseMax((p.head<2>() / p.z()).cast<double>().cwiseAbs());
  return half;
}

std::vector<FlatReading> readings_on(const DominantPlane& plane,
                                     const std::vector<Eigen::Vector3f>& points, float band,
                                     const Eigen::Vector2d& half) {
  std::vector<FlatReading> readings;
  const Eigen::Vector3d normal = plane.normal.cast<double>();
  for (const Eigen::Vector3f& point : points) {
    if (!plane.holds(point, band)) continue;
    const Eigen::Vector3d p = point.cast<double>(), ray = p / p.z();
    constexpr double kLeastFacing = 0.35;  // cosine: beyond 70 degrees readings are drawn aside
    if (std::abs(ray.normalized().dot(normal)) < kLeastFacing) continue;
    readings.push_back({ray.x() / half.x(), ray.y() / half.y(), p.z(),
                        static_cast<double>(plane.offset) / ray.dot(normal)});
  }
  return readings;
}

}  // namespace

std::optional<WarpCheck> check_warp(std::span<const Eigen::Vector3f> all, const NoiseModel& noise,
                                    const WarpCheckOptions& options, const Watch& watch) {
  std::vector<Eigen::Vector3f> points, some;
  std::vector<float> depths;
  for (const Eigen::Vector3f& p : all)
    if (p.allFinite() && p.z() > 0.1F) points.push_back(p);
  if (points.empty()) return std::nullopt;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kMostSearched);
  for (std::size_t i = 0; i < points.size(); i += step) {
    some.push_back(points[i]);
    depths.push_back(points[i].z());
  }
  const double typical_m = noise.axial_m(static_cast<double>(median(depths)));
  const auto planes = dominant_planes(
      some, {.size_m = options.size_m, .noise_m = typical_m, .seed = options.seed}, watch);
  if (watch.cancelled()) return std::nullopt;
  // Wide enough for noise and a bend that matters.
  const auto band = static_cast<float>(4 * typical_m + 0.015);
  const Eigen::Vector2d half = half_sides(points);
  const std::size_t least =
      points.size() / (4 * std::size_t{FlatCells::kColumns} * FlatCells::kRows) + 1;
  std::vector<FlatCells> cells;
  std::vector<double> ranges;
  for (const DominantPlane& plane : planes) {
    const auto readings = readings_on(plane, points, band, half);
    cells.push_back(gather_cells(readings, noise, options.correlated, least));
    const auto filled = std::ranges::count_if(cells.back().cells,
                                              [](const auto& cell) { return cell.readings > 0; });
    constexpr auto kLeastCells = 30;  // a tenth of the picture
    if (filled < kLeastCells) {
      cells.pop_back();
      continue;
    }
    for (const auto& cell : cells.back().cells)
      if (cell.readings > 0) ranges.push_back(cell.z_m);
  }
  if (cells.empty()) return std::nullopt;
  const auto fit = fit_flat_warp(cells, kSquares);
  if (!fit) return std::nullopt;

  WarpCheck check;
  check.range_m = median(ranges);
  check.stated_u_m = options.warp_u_m;
  const Eigen::Map<const Eigen::Vector3d> share(fit->share.data());
  // Stated at the corners, where both squares add: half of its variance each, and of the product.
  const double other_m2 = options.warp_u_m * options.warp_u_m + kFlatness_u_m * kFlatness_u_m;
  const Eigen::Matrix3d covariance =
      Eigen::Matrix3d(fit->covariance) +
      Eigen::Matrix3d::Identity() * (other_m2 / 2 / (check.range_m * check.range_m));
  check.statistic = share.dot(Eigen::LDLT<Eigen::Matrix3d>(covariance).solve(share));
  check.limit = kChiSquare3;
  check.freedom = kSquares;
  check.false_alarm = 0.01;
  check.is_contradicted = check.statistic > check.limit;
  const Eigen::Vector3d corner(1, 0, 1);
  check.corner_m = check.range_m * std::hypot(corner.dot(share), share[1]);
  check.corner_u_m =
      std::hypot(check.range_m * std::sqrt(corner.dot(fit->covariance * corner)), kFlatness_u_m);
  return check;
}

}  // namespace spool
