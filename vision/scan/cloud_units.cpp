// Which unit a file without one is in, and how its coordinates become metres near an origin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/cloud_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spool {

Eigen::AlignedBox3d robust_box(std::span<const Eigen::Vector3d> points) {
  constexpr std::size_t kEnough = 100000;  // of them tell the size as well as all
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
  Eigen::AlignedBox3d box;
  const std::size_t n = values[0].size();
  if (n == 0) return box;
  const std::size_t left_out = n / 200;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double>& all = values[axis];
    const auto low = all.begin() + static_cast<std::ptrdiff_t>(left_out);
    const auto high = all.begin() + static_cast<std::ptrdiff_t>(n - 1 - left_out);
    std::nth_element(all.begin(), low, all.end());
    box.min()[static_cast<Eigen::Index>(axis)] = *low;
    std::nth_element(all.begin(), high, all.end());
    box.max()[static_cast<Eigen::Index>(axis)] = *high;
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
    const Eigen::Vector3d middle = robust_box(points).center() * to_metres;
    if (middle.allFinite()) cloud.origin = middle.array().round();
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
