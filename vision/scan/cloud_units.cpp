// Which unit a file without one is in, and how its coordinates become metres near an origin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/cloud_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spool {

namespace {

// x, y and z apart, of so many of the finite points as tell the size as well as all.
std::array<std::vector<double>, 3> axes_of(std::span<const Eigen::Vector3d> points) {
  constexpr std::size_t kEnough = 100000;
  const auto finite = static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(),
                    [](const Eigen::Vector3d& point) { return point.allFinite(); }));
  const std::size_t step = 1 + finite / kEnough;
  std::array<std::vector<double>, 3> values;
  std::size_t met = 0;
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite() || met++ % step != 0) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[axis].push_back(point[static_cast<Eigen::Index>(axis)]);
  }
  return values;
}

// The value with `rank` smaller ones.
double ranked(std::vector<double>& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Eigen::AlignedBox3d robust_box(std::span<const Eigen::Vector3d> points) {
  auto values = axes_of(points);
  Eigen::AlignedBox3d box;
  const std::size_t n = values[0].size();
  if (n == 0) return box;
  const std::size_t left_out = n / 200;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min()[static_cast<Eigen::Index>(axis)] = ranked(values[axis], left_out);
    box.max()[static_cast<Eigen::Index>(axis)] = ranked(values[axis], n - 1 - left_out);
  }
  return box;
}

std::optional<LengthUnit> unit_for_extent(double extent) {
  if (extent >= 0.02 && extent <= 150) return LengthUnit::kMetre;
  if (extent >= 300 && extent <= 60000) return LengthUnit::kMillimetre;
  return std::nullopt;
}

void set_points(PointCloud& cloud, std::span<const Eigen::Vector3d> points, LengthUnit unit) {
  const double to_metres = metres(unit);
  double furthest = 0;
  for (const Eigen::Vector3d& point : points)
    if (point.allFinite()) furthest = std::max(furthest, point.cwiseAbs().maxCoeff() * to_metres);
  cloud.origin.setZero();
  if (furthest >= kFloatReach) {
    auto values = axes_of(points);
    for (std::size_t axis = 0; axis < 3; ++axis)
      cloud.origin[static_cast<Eigen::Index>(axis)] =
          std::round(ranked(values[axis], values[axis].size() / 2) * to_metres);
  }
  cloud.points.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = (points[i] * to_metres - cloud.origin).cast<float>();
    cloud.points[i] = point.allFinite()
                          ? point
                          : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  }
}

}  // namespace spool
