// A design mesh made ready for drawing: normals that break at creases, edges worth a line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/triangle_mesh.h"

namespace spool::render {

struct MeshVertex {
  Eigen::Vector3f position;  // m, design frame
  Eigen::Vector3f normal;    // unit
  float part = -1;  // a float so that one vertex layout serves every driver; exact to 16 million
};

// An edge between two triangles, or the rim of one.
struct MeshEdge {
  Eigen::Vector3f from;  // m, design frame
  Eigen::Vector3f to;
  Eigen::Vector3f
      normal_a;  // of the two triangles, turned the same way; outline where one faces the eye
  Eigen::Vector3f normal_b;  // and the other does not
  std::int32_t part = -1;
  std::int32_t other_part = -1;  // of the second triangle
};

struct MeshGeometry {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
  std::vector<MeshEdge> creases;       // sharp edges, rims, and where two parts meet: always drawn
  std::vector<MeshEdge> smooth;        // may be part of an outline
  // Every part is a closed solid, wound outwards: its back faces are never seen and need not be
  // drawn.
  bool is_solid = false;
};

// Triangles with equal corners are left out. `triangle_part` is as long as the triangles or empty
// (no parts). Corners within a micrometre of one another are one: foreign files repeat vertices for
// every triangle.
[[nodiscard]] MeshGeometry prepare_mesh(const TriangleMesh& mesh,
                                        std::span<const std::int32_t> triangle_part);

// Appends those smooth edges that are outline seen from `eye` (m, design frame).
void append_outline(std::span<const MeshEdge> smooth, const Eigen::Vector3f& eye,
                    std::vector<MeshEdge>& outline);

}  // namespace spool::render
