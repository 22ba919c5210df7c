// Segments and boxes in the plane: crossings, and how far one reaches into the other.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spool::guide {

struct Segment2 {
  Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();
};

[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Where two segments cross, as fractions of each from its a; nothing where they do not or are
// parallel. Touching ends count.
struct Crossing {
  double of_first = 0, of_second = 0;
};
[[nodiscard]] inline std::optional<Crossing> crossing(const Segment2& one, const Segment2& other) {
  const Eigen::Vector2d u = one.b - one.a, v = other.b - other.a, w = other.a - one.a;
  const double area = cross(u, v);
  if (std::abs(area) < 1e-9 * (1 + u.norm() * v.norm())) return std::nullopt;
  const Crossing at{cross(w, v) / area, cross(w, u) / area};
  const auto within = [](double t) { return t >= 0 && t <= 1; };
  if (!within(at.of_first) || !within(at.of_second)) return std::nullopt;
  return at;
}

// The length of a segment within a box (Liang and Barsky 1984).
[[nodiscard]] inline double length_within(const Segment2& segment, const Eigen::AlignedBox2d& box) {
  const Eigen::Vector2d along = segment.b - segment.a;
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    if (std::abs(along[k]) < 1e-12) {
      if (segment.a[k] < box.min()[k] || segment.a[k] > box.max()[k]) return 0;
      continue;
    }
    const double one = (box.min()[k] - segment.a[k]) / along[k];
    const double other = (box.max()[k] - segment.a[k]) / along[k];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return to > from ? (to - from) * along.norm() : 0;
}

}  // namespace spool::guide
