// Boxes and cylinders as closed triangle meshes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/solids.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace spool::simulator {

TriangleMesh box_mesh(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                               (corner & 4) != 0 ? 1 : -1);
    mesh.vertices.push_back((0.5 * sign.cwiseProduct(size)).cast<float>());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh cylinder_mesh(double diameter, double length, int facets) {
  assert(facets >= 3 && "a cylinder of three facets or more");
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(facets);
  mesh.vertices.emplace_back(0.0F, 0.0F, static_cast<float>(-length / 2));
  mesh.vertices.emplace_back(0.0F, 0.0F, static_cast<float>(length / 2));
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const Eigen::Vector3d at(std::cos(angle) * diameter / 2, std::sin(angle) * diameter / 2,
                             length / 2);
    mesh.vertices.push_back(Eigen::Vector3d(at.x(), at.y(), -at.z()).cast<float>());
    mesh.vertices.push_back(at.cast<float>());
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);  // bottom; the top is one further
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

}  // namespace spool::simulator
