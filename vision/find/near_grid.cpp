// Whether a place is near a cloud, answered by one look at a grid: what tests millions of poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/near_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace spool {

NearGrid::NearGrid(std::span<const Eigen::Vector3f> points, double distance_m) {
  assert(distance_m > 0 && "a distance");
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    if (p.allFinite()) box.extend(p.cast<double>());
  if (box.isEmpty()) return;
  constexpr double kMostCells = 536870912.0;  // 2^29
  constexpr double kMostAlong = 1048576.0;    // 2^20: a float counts them with room to spare
  double edge = distance_m / 2;
  Eigen::Array3d cells;
  while (true) {
    const double border = distance_m + edge;  // what is marked beyond the outermost points
    cells = ((box.sizes().array() + 2 * border) / edge).ceil();
    if (cells.prod() <= kMostCells && cells.maxCoeff() <= kMostAlong) break;
    edge *= 1.26;  // half the cells
    distance_m = 2 * edge;
  }
  distance_m_ = distance_m;
  low_ = (box.min().array() - distance_m - edge).cast<float>();
  per_m_ = static_cast<float>(1 / edge);
  size_ = cells.cast<float>();
  columns_ = static_cast<std::uint64_t>(cells.x());
  rows_ = static_cast<std::uint64_t>(cells.y());
  bits_.assign(static_cast<std::size_t>(cells.prod() / 64) + 1, 0);
  slack_m_ = 0.5 * std::sqrt(3.0) * edge;

  const auto reach = static_cast<int>(std::ceil(distance_m / edge));
  const double squared = distance_m * distance_m;
  for (const Eigen::Vector3f& p : points) {
    if (!p.allFinite()) continue;
    const Eigen::Array3d at = (p - low_).cast<double>().array() / edge;
    const Eigen::Array3i cell = at.floor().cast<int>();
    for (int z = cell.z() - reach; z <= cell.z() + reach; ++z)
      for (int y = cell.y() - reach; y <= cell.y() + reach; ++y)
        for (int x = cell.x() - reach; x <= cell.x() + reach; ++x) {
          const Eigen::Array3d c(x, y, z);
          if ((c < 0).any() || (c >= cells).any()) continue;
          if ((c + 0.5 - at).matrix().squaredNorm() * edge * edge > squared) continue;
          const auto bit =
              (static_cast<std::uint64_t>(z) * rows_ + static_cast<std::uint64_t>(y)) * columns_ +
              static_cast<std::uint64_t>(x);
          bits_[bit >> 6U] |= std::uint64_t{1} << (bit & 63U);
        }
  }
}

}  // namespace spool
