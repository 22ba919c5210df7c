// Normals that give the right sign of distance everywhere on a mesh, also at its edges and corners.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/triangle_mesh.h"

namespace spool {

// Unit normals of a triangle abc by feature as TrianglePoint numbers them: inside, edges ab bc ca,
// corners a b c.
using TriangleNormals = std::array<Eigen::Vector3f, 7>;

// Angle-weighted pseudonormals (Baerentzen & Aanaes, IEEE TVCG 11(3), 2005): at an edge the sum of
// the normals that meet there, at a corner the sum weighted by the angles. Vertices on one another
// are one within a part; parts never mix (two parts that touch stay two solids). A triangle without
// area has zeros.
[[nodiscard]] std::vector<TriangleNormals> pseudonormals(const TriangleMesh& mesh,
                                                         std::span<const std::int32_t> part);

}  // namespace spool
