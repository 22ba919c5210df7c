// What makes a solid one: every edge met twice, outside out, inside in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/piping/solid_checks.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include <Eigen/Geometry>

namespace spool::test {

using Eigen::Vector3d;

double volume(const piping::Solid& solid) {
  double six = 0;
  for (const Triangle& t : solid.triangles)
    six += solid.vertices[t[0]].dot(solid.vertices[t[1]].cross(solid.vertices[t[2]]));
  return six / 6;
}

std::string fault_of(const piping::Solid& solid) {
  if (solid.triangles.empty()) return "no triangles";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] >= solid.vertices.size()) return "a corner that is no vertex";
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
    const Vector3d normal = (solid.vertices[t[1]] - solid.vertices[t[0]])
                                .cross(solid.vertices[t[2]] - solid.vertices[t[0]]);
    if (!(normal.norm() > 1e-14)) return "a flat triangle";
  }
  for (const auto& [edge, times] : edges) {
    if (times != 1) return "an edge that is gone along twice the same way";
    if (edges.find({edge.second, edge.first}) == edges.end()) return "an open edge";
  }
  return volume(solid) > 0 ? "" : "inside out";
}

double winding(const piping::Solid& solid, const Vector3d& point) {
  double angle = 0;
  for (const Triangle& t : solid.triangles) {
    const Vector3d a = solid.vertices[t[0]] - point;
    const Vector3d b = solid.vertices[t[1]] - point;
    const Vector3d c = solid.vertices[t[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

int disagreements(const piping::Solid& solid, double margin,
                  const std::function<bool(const Vector3d&)>& is_inside, int places) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : solid.vertices) box.extend(vertex);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.05, 1.05);
  int wrong = 0;
  for (int i = 0; i < places; ++i) {
    const Vector3d share(uniform(random), uniform(random), uniform(random));
    const Vector3d p = box.min() + share.cwiseProduct(box.sizes());
    const bool inside = is_inside(p);
    bool is_clear = true;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-margin, margin})
        is_clear = is_clear && is_inside(p + side * Vector3d::Unit(axis)) == inside;
    }
    if (is_clear && std::abs(winding(solid, p) - (inside ? 1 : 0)) > 1e-6) ++wrong;
  }
  return wrong;
}

}  // namespace spool::test
