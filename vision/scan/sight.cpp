// What a depth camera saw in each direction: whether a place is seen through, hidden, or not looked
// at.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spool {
namespace {

constexpr float kPointsPerCell = 4;
constexpr int kMostSide = 512;  // cells; memory stays bounded
constexpr int kLeastRound = 6;  // of the nine cells round a direction that have a reading
constexpr float kInf = std::numeric_limits<float>::infinity();

bool is_before_camera(const Eigen::Vector3f& point) { return point.allFinite() && point.z() > 0; }

Eigen::Array2f direction(const Eigen::Vector3f& point) {
  return point.head<2>().array() / point.z();
}

}  // namespace

Sight::Sight(std::span<const Eigen::Vector3f> scan) {
  Eigen::Array2f low = Eigen::Array2f::Constant(kInf), high = -low;
  std::size_t count = 0;
  for (const Eigen::Vector3f& point : scan) {
    if (!is_before_camera(point)) continue;
    low = low.min(direction(point));
    high = high.max(direction(point));
    ++count;
  }
  if (count < 2) return;
  const Eigen::Array2f size = (high - low).max(1e-6F);
  const float side = std::max(std::sqrt(size.prod() * kPointsPerCell / static_cast<float>(count)),
                              size.maxCoeff() / static_cast<float>(kMostSide));
  low_ = low;
  cells_per_unit_ = 1 / side;
  columns_ = static_cast<int>(size.x() * cells_per_unit_) + 1;
  rows_ = static_cast<int>(size.y() * cells_per_unit_) + 1;
  cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                {kInf, -kInf});
  for (const Eigen::Vector3f& point : scan) {
    int column = 0, row = 0;
    if (!point.allFinite() || !cell_of(point, column, row)) continue;
    Cell& cell = cells_[index_of(column, row)];
    cell.nearest = std::min(cell.nearest, point.z());
    cell.farthest = std::max(cell.farthest, point.z());
  }
}

bool Sight::cell_of(const Eigen::Vector3f& place, int& column, int& row) const {
  if (!is_before_camera(place)) return false;
  const Eigen::Array2f at = (direction(place) - low_) * cells_per_unit_;
  if (!(at >= 0).all() || !(at.x() < static_cast<float>(columns_)) ||
      !(at.y() < static_cast<float>(rows_)))
    return false;
  column = static_cast<int>(at.x());
  row = static_cast<int>(at.y());
  return true;
}

Seen Sight::at(const Eigen::Vector3f& place, float gate_m) const {
  int column = 0, row = 0;
  if (!cell_of(place, column, row)) return Seen::kNot;
  float nearest = kInf, farthest = -kInf;
  int read = 0;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
      const Cell& cell = cells_[index_of(c, r)];
      if (cell.nearest > cell.farthest) continue;
      nearest = std::min(nearest, cell.nearest);
      farthest = std::max(farthest, cell.farthest);
      ++read;
    }
  if (read < kLeastRound) return Seen::kNot;
  if (nearest > place.z() + gate_m) return Seen::kThrough;
  if (farthest < place.z() - gate_m) return Seen::kHidden;
  return Seen::kThere;
}

}  // namespace spool
