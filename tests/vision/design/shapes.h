// Closed meshes whose distance is known by formula.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool::test {

// Meshes that share no vertex between triangles, as STL has them: welding is the library's
// business.
[[nodiscard]] DesignModel box_design(const Eigen::Vector3d& centre, const Eigen::Vector3d& half);
[[nodiscard]] DesignModel torus_design(double R, double r, int around, int across);
[[nodiscard]] DesignModel capped_cylinder_design(double radius, double length, int around);
// A needle: a tetrahedron with a sharp tip, where the sign of the nearest face alone is wrong.
[[nodiscard]] DesignModel needle_design();

// Adds the parts of one design to another.
void append_design(DesignModel& into, const DesignModel& from);

// Signed distances by formula (m), + outside.
[[nodiscard]] double box_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& centre,
                                  const Eigen::Vector3d& half);
[[nodiscard]] double torus_distance(const Eigen::Vector3d& p, double R, double r);

// Unsigned distance to one triangle by another road than the library: the foot on the plane where
// it falls inside, else the nearest of three segments, all in double.
[[nodiscard]] double triangle_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c);

// Distance along a ray to a triangle (Moeller & Trumbore 1997, in double); negative where it
// misses.
[[nodiscard]] double ray_distance(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                  const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

[[nodiscard]] Eigen::Vector3d corner(const DesignModel& design, std::size_t triangle,
                                     std::size_t k);

}  // namespace spool::test
