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
    for (int x = 0; x <= 1; ++x)
      for (int y = 0; y <= 1; ++y)
        for (int z = 0; z <= 1; ++z)
          for (std::uint32_t i = heads_[slot(low + Eigen::Vector3i(x, y, z))]; i != kNone;
               i = next_[i])
            if ((points_[i] - p).squaredNorm() < spacing2_) return false;
    return true;
  }

  void add(const Eigen::Vector3f& p) {
    std::uint32_t& head = heads_[slot(cell_of(p))];
    points_.push_back(p);
    next_.push_back(head);
    head = static_cast<std::uint32_t>(points_.size() - 1);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  [[nodiscard]] Eigen::Vector3i cell_of(const Eigen::Vector3f& p) const {
    return (p * inverse_).array().floor().cast<int>();
  }
  [[nodiscard]] std::size_t slot(const Eigen::Vector3i& cell) const {
    const auto part = [](int value, std::uint64_t prime) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) * prime;
    };
    const std::uint64_t hash = part(cell.x(), 0x9E3779B97F4A7C15U) ^
                               part(cell.y(), 0xC2B2AE3D27D4EB4FU) ^
                               part(cell.z(), 0x165667B19E3779F9U);
    return static_cast<std::size_t>(hash ^ (hash >> 29)) & (heads_.size() - 1);
  }

  float inverse_, spacing2_;
  std::vector<std::uint32_t> heads_, next_;
  std::vector<Eigen::Vector3f> points_;
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
