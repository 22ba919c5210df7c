// Closed bodies of triangles out of loops of shared vertices.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/triangle_mesh.h"

namespace spool::piping {

// Metres, in the frame of who builds it. Loops share their vertices, so what is closed in its
// topology has no seam.
struct Solid {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;  // counter-clockwise seen from outside
};

// Vertices of a closed curve in order.
using Loop = std::vector<std::uint32_t>;

inline constexpr double kChordError = 1e-4;  // m that a polygon lies inside its circle

// Sides of the polygon for a circle of this radius (m): a multiple of 4, from 24 to 240.
[[nodiscard]] int sides_of(double radius);

[[nodiscard]] Loop add_loop(Solid& solid, std::span<const Eigen::Vector3d> points);

// A circle about the frame's z axis through its origin, anticlockwise from x.
[[nodiscard]] Loop add_circle(Solid& solid, const Eigen::Isometry3d& frame, double radius,
                              int sides);

// The band from one loop to another of the same length; outside is to the right of the way from
// `lower` to `upper` while the loops go anticlockwise seen from the upper side's outside, as on a
// cylinder's wall from bottom to top.
void add_strip(Solid& solid, const Loop& lower, const Loop& upper);

// The same between loops of different lengths, by their angles (rad, rising, less than a turn).
void add_zip(Solid& solid, const Loop& lower, std::span<const double> lower_angles,
             const Loop& upper, std::span<const double> upper_angles);

// Closes a loop by a point that looks to the side from which it goes anticlockwise.
void add_fan(Solid& solid, const Loop& loop, const Eigen::Vector3d& apex);

// A cross-section of a tube: circles about the frame's z axis. Inner radius 0: solid rod.
struct Station {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  double outer = 0, inner = 0;  // m
};

// A hollow or solid body through stations, one after the other along their z axes; closed at both
// ends. At least two stations, all hollow or all solid.
void add_tube(Solid& solid, std::span<const Station> stations);

// A body of revolution about z from an open chain of (radius, z) whose first and last points lie on
// the axis; outside is to the right of the chain, seen with r to the right and z up.
void add_revolved(Solid& solid, std::span<const Eigen::Vector2d> chain);

}  // namespace spool::piping
