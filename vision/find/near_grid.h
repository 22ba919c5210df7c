// Whether a place is near a cloud, answered by one look at a grid: what tests millions of poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace spool {

// Cells, half the distance wide, are marked whose centre is within the distance of a point; a place
// is near where its cell is marked. So every place nearer than distance_m() - slack_m() is near,
// none further than distance_m() + slack_m() is. Const queries from many threads.
class NearGrid {
 public:
  NearGrid() = default;
  // Over the finite `points` (m), for one `distance_m` (m, over 0), which grows where the cloud is
  // so wide that it would take more than 2^29 cells (64 MiB).
  NearGrid(std::span<const Eigen::Vector3f> points, double distance_m);

  [[nodiscard]] bool is_near(const Eigen::Vector3f& place) const {
    const Eigen::Array3f cell = (place - low_).array() * per_m_;
    // Negated, so that what is not a number is outside.
    if (!((cell >= 0).all() && (cell < size_).all())) return false;
    const auto at =
        (static_cast<std::uint64_t>(cell.z()) * rows_ + static_cast<std::uint64_t>(cell.y())) *
            columns_ +
        static_cast<std::uint64_t>(cell.x());
    return ((bits_[at >> 6U] >> (at & 63U)) & 1U) != 0;
  }
  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] double slack_m() const { return slack_m_; }  // m, half a cell's diagonal

 private:
  Eigen::Vector3f low_ = Eigen::Vector3f::Zero();
  float per_m_ = 0;
  Eigen::Array3f size_ = Eigen::Array3f::Zero();  // cells along each axis
  std::uint64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint64_t> bits_;
  double distance_m_ = 0;
  double slack_m_ = 0;
};

}  // namespace spool
