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

// A set bit: some point lies within `near_m` of the cell's middle, so that near is near to within a
// cell, which is two thirds of it. Blocks of 8x8x8 cells in a hash table, only where there are
// points: what a hall leaves empty costs nothing, and a stray point far off costs no detail.
// Immutable; const queries from many threads.
class Occupancy {
 public:
  Occupancy() = default;
  // Points (m). Left out are those that are not finite, and those some hundred thousand times
  // `near_m` from where most are.
  Occupancy(std::span<const Eigen::Vector3f> points, double near_m);

  [[nodiscard]] bool is_near(const Eigen::Vector3f& query) const {
    const Eigen::Array3f cell = (query - corner_).array() * per_m_;
    if (!((cell >= 0.0F).all() && (cell < size_).all())) return false;  // NaN too
    const auto i = static_cast<std::uint32_t>(cell.x());
    const auto j = static_cast<std::uint32_t>(cell.y());
    const auto k = static_cast<std::uint32_t>(cell.z());
    const std::uint64_t key = key_of(i, j, k);
    std::size_t at = first_slot(key);
    while (slots_[at].key != key) {
      if (slots_[at].key == 0) return false;
      at = (at + 1) & (slots_.size() - 1);
    }
    return ((bits_[slots_[at].first + (k & 7U)] >> bit_of(i, j)) & 1U) != 0;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;    // 0: free
    std::uint32_t first = 0;  // of the block's eight words
  };

  // Of the block that holds a cell; never 0.
  static std::uint64_t key_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return 1 + ((std::uint64_t{k >> 3U} << 40U) | (std::uint64_t{j >> 3U} << 20U) | (i >> 3U));
  }
  static std::uint32_t bit_of(std::uint32_t i, std::uint32_t j) { return (j & 7U) * 8 + (i & 7U); }
  [[nodiscard]] std::size_t first_slot(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> shift_);  // Fibonacci hashing
  }
  [[nodiscard]] std::size_t slot_for(std::uint64_t key) const;
  void resize_slots(std::uint32_t bits);
  void set(const Eigen::Array3i& cell);

  float per_m_ = 0;
  float size_ = 0;  // cells along each side of the cube that is looked at
  Eigen::Vector3f corner_ = Eigen::Vector3f::Zero();
  std::uint32_t shift_ = 0;          // 64 less the bits of a slot's number
  std::vector<Slot> slots_;          // a power of two of them, at most half taken
  std::vector<std::uint64_t> bits_;  // eight words a block
};

}  // namespace spool
