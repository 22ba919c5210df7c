// Boxes and cylinders as closed triangle meshes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "vision/core/triangle_mesh.h"

namespace spool::simulator {

// Edges along the axes, centred on the origin; size in metres.
[[nodiscard]] TriangleMesh box_mesh(const Eigen::Vector3d& size);

// Axis z, centred on the origin. The facets' edges lie on the cylinder: with n facets the surface
// is inside by radius * (1 - cos(pi / n)) at most.
[[nodiscard]] TriangleMesh cylinder_mesh(double diameter, double length, int facets);

}  // namespace spool::simulator
