// A polygon of a mesh file cut into triangles: ear after ear.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/polygon.h"

#include <Eigen/Geometry>

namespace spool {
namespace {

// Cutting ears takes time with the cube of the corners; no face that is drawn by hand has as many.
constexpr std::size_t kMostCorners = 500;

// The polygon's normal as long as twice its area (Newell), whatever its corners.
Eigen::Vector3d area_vector(std::span<const Eigen::Vector3d> vertices,
                            std::span<const std::uint32_t> loop) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& base = vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += (vertices[loop[i]] - base).cross(vertices[loop[i + 1]] - base);
  }
  return sum;
}

}  // namespace

void triangulate_polygon(std::span<const Eigen::Vector3d> vertices,
                         std::span<const std::uint32_t> loop, std::vector<Triangle>& out) {
  if (loop.size() < 3) return;
  const Eigen::Vector3d up = area_vector(vertices, loop);
  // Twice the signed area of three corners, seen along the normal.
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).dot(up);
  };
  std::vector<std::uint32_t> left(loop.begin(), loop.end());
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = left.size();
    const std::uint32_t a = left[(i + n - 1) % n];
    const std::uint32_t b = left[i];
    const std::uint32_t c = left[(i + 1) % n];
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::uint32_t other : left) {
      if (other == a || other == b || other == c) continue;
      if (turn(a, b, other) >= 0 && turn(b, c, other) >= 0 && turn(c, a, other) >= 0) return false;
    }
    return true;
  };
  while (left.size() > 3 && left.size() <= kMostCorners) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(ear)) ++ear;
    if (ear == left.size())
      break;  // it crosses itself or has no area: a fan is as good as anything
    const std::size_t n = left.size();
    out.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) out.push_back({left[0], left[i], left[i + 1]});
}

}  // namespace spool
