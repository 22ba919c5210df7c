// Points kept no nearer to each other than a distance: what thinning by Poisson disks leaves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>

namespace spool::campaign {

// A hashed grid of cells two spacings wide, so that eight of them hold all that is near a point.
// Const queries from many threads while nothing is added.
class PointSpacing {
 public:
  PointSpacing(double spacing_m, std::size_t expected_points)
      : inverse_(static_cast<float>(0.5 / spacing_m)),
        spacing2_(static_cast<float>(spacing_m * spacing_m)) {
    std::size_t size = 1024;
    while (size < 2 * expected_points) size *= 2;
    heads_.assign(size, kNone);
  }

  [[nodiscard]] bool has_room(const Eigen::Vector3f& p) const {
    const Eigen::Vector3i low = cell_of(p - Eigen::Vector3f::Constant(0.5F / inverse_));
    for (int x = low.x(); x <= low.x() + 1; ++x)
      for (int y = low.y(); y <= low.y() + 1; ++y)
        for (int z = low.z(); z <= low.z() + 1; ++z)
          for (std::uint32_t i = heads_[slot(x, y, z)]; i != kNone; i = points_[i].next)
            if ((points_[i].point - p).squaredNorm() < spacing2_) return false;
    return true;
  }

  void add(const Eigen::Vector3f& p) {
    const Eigen::Vector3i cell = cell_of(p);
    std::uint32_t& head = heads_[slot(cell.x(), cell.y(), cell.z())];
    points_.push_back({p, head});
    head = static_cast<std::uint32_t>(points_.size() - 1);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  struct Entry {
    Eigen::Vector3f point;
    std::uint32_t next;  // in the same slot
  };

  [[nodiscard]] Eigen::Vector3i cell_of(const Eigen::Vector3f& p) const {
    return (p * inverse_).array().floor().cast<int>();
  }
  // Blocks of 4 x 4 x 4 cells are hashed, so that what lies near in space does so in memory.
  [[nodiscard]] std::size_t slot(int x, int y, int z) const {
    const auto part = [](int value, std::uint64_t factor) {
      return static_cast<std::uint64_t>(std::int64_t{value >> 2}) * factor;
    };
    const std::uint64_t hash =
        part(x, 0x9E3779B97F4A7C15U) ^ part(y, 0xC2B2AE3D27D4EB4FU) ^ part(z, 0x165667B19E3779F9U);
    const auto within = static_cast<std::uint64_t>((x & 3) | (y & 3) << 2 | (z & 3) << 4);
    return static_cast<std::size_t>((hash ^ (hash >> 29)) << 6 | within) & (heads_.size() - 1);
  }

  float inverse_, spacing2_;
  std::vector<std::uint32_t> heads_;
  std::vector<Entry> points_;
};

// Disks as wide as the spacing, put down at random until no more fit, cover this much (Feder 1980).
inline constexpr double kJammed = 0.547;
// Of that, what is aimed at: the last tenths take many times the tries of the first.
inline constexpr double kFilled = 0.75;

// How many points (1/m2) of that spacing there are then, and the spacing (m) for so many.
[[nodiscard]] inline double density_at(double spacing_m) {
  return 4 * kJammed * kFilled / (std::numbers::pi * spacing_m * spacing_m);
}
[[nodiscard]] inline double spacing_for(double density) {
  return std::sqrt(4 * kJammed * kFilled / (std::numbers::pi * density));
}

}  // namespace spool::campaign
