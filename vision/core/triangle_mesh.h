// Triangles over shared vertices.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace spool {

using Triangle = std::array<std::uint32_t, 3>;  // counter-clockwise seen from outside

struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;  // m
  std::vector<Triangle> triangles;        // each index < vertices.size()
};

}  // namespace spool
