// A polygon of a mesh file cut into triangles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/triangle_mesh.h"

namespace spool {

// Appends triangles that cover the polygon whose corners `loop` names in order, wound as it is:
// ears are cut off one by one (Meisters 1975), so that it may be concave. Corners at any place in
// space; the polygon is taken to be nearly flat. Less than three corners give nothing.
void triangulate_polygon(std::span<const Eigen::Vector3d> vertices,
                         std::span<const std::uint32_t> loop, std::vector<Triangle>& out);

}  // namespace spool
