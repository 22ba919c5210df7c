// Is there a scan point near: one bit a cell, so that a pose is tried at a few nanoseconds a
// sample.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace spool {

// A set bit: some point lies within about `near_m` of the cell. Blocks of 8x8x8 cells, kept only
// where there are points, so that a few far points do not cost a hall's worth of memory. Immutable;
// const queries from many threads.
class Occupancy {
 public:
  Occupancy() = default;
  // Points (m); those that are not finite are left out.
  Occupancy(std::span<const Eigen::Vector3f> points, double near_m);

  [[nodiscard]] bool is_near(const Eigen::Vector3f& query) const {
    const Eigen::Array3f cell = (query - corner_).array() * per_m_;
    if (!((cell >= 0.0F).all() && (cell < size_f_).all())) return false;  // NaN too
    const auto i = static_cast<std::uint32_t>(cell.x());
    const auto j = static_cast<std::uint32_t>(cell.y());
    const auto k = static_cast<std::uint32_t>(cell.z());
    const std::uint32_t block =
        blocks_[(std::size_t{k >> 3U} * size_y_ + (j >> 3U)) * size_x_ + (i >> 3U)];
    const std::uint64_t row = bits_[std::size_t{block} * 8 + (k & 7U)];
    return ((row >> ((j & 7U) * 8 + (i & 7U))) & 1U) != 0;
  }

 private:
  void set(const Eigen::Array3i& cell);

  float per_m_ = 0;
  Eigen::Vector3f corner_ = Eigen::Vector3f::Zero();
  Eigen::Array3f size_f_ = Eigen::Array3f::Zero();
  std::size_t size_x_ = 0, size_y_ = 0, size_z_ = 0;                    // in blocks
  std::vector<std::uint32_t> blocks_;                                   // 0: the empty block
  std::vector<std::uint64_t> bits_ = std::vector<std::uint64_t>(8, 0);  // eight words a block
};

}  // namespace spool
