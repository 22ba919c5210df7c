// The point of a triangle closest to the origin, and whether it lies inside, on an edge or at a
// corner.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spool {

// Where on a triangle abc a point lies: 0 inside, 1 2 3 on edge ab bc ca, 4 5 6 at corner a b c.
struct TrianglePoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  int feature = 0;
};

// Closest to the origin: callers subtract the query first, which keeps the digits that float loses
// far from it. Voronoi regions as in Ericson, Real-Time Collision Detection (2005), 5.1.5.
[[nodiscard]] inline TrianglePoint closest_to_origin(const Eigen::Vector3f& a,
                                                     const Eigen::Vector3f& b,
                                                     const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  const float d1 = -ab.dot(a);
  const float d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return {a, 4};
  const float d3 = -ab.dot(b);
  const float d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return {b, 5};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + ab * (d1 / (d1 - d3)), 1};
  const float d5 = -ab.dot(c);
  const float d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return {c, 6};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + ac * (d2 / (d2 - d6)), 3};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return {b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), 2};
  }
  // Inside: the foot of the perpendicular. By the plane rather than by va, vb, vc, whose rounding
  // grows with the square of the distance.
  const Eigen::Vector3f normal = ab.cross(ac);
  return {normal * (normal.dot(a) / normal.squaredNorm()), 0};
}

}  // namespace spool
