// A piece of surface known by its equation: rays hit it exactly, points fall on it evenly.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "tools/campaign/random.h"
#include "vision/core/pose.h"

namespace spool::campaign {

// Each in its own frame, metres.
struct Cylinder {  // about z, from z0 to z1
  double radius = 0, z0 = 0, z1 = 0;
};
struct Cone {  // about z, radius r0 at z0 to r1 at z1
  double r0 = 0, r1 = 0, z0 = 0, z1 = 0;
};
struct Annulus {  // in z = 0, with bolt holes if any; the first from x about +z by `clocking_rad`
  double inner = 0, outer = 0;
  int holes = 0;
  double circle_radius = 0, hole_radius = 0, clocking_rad = 0;
};
struct Torus {  // tube round a circle in z = 0, from x about +z by `angle_rad`
  double bend = 0, tube = 0, angle_rad = 0;
};
struct Dome {  // the upper half of an ellipsoid of revolution about z, standing on z = 0
  double radius = 0, height = 0;
};
struct Rectangle {  // in z = 0, half sides; an opening of half sides hole_x, hole_y where not zero
  double x = 0, y = 0, hole_x = 0, hole_y = 0;
};
struct Block {  // a solid box of half sides `half`
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
};
using Shape = std::variant<Cylinder, Cone, Annulus, Torus, Dome, Rectangle, Block>;

// Where a tee's other leg passes: what lies within `radius` of the line through the origin along
// `axis`, on the side that `side` points to, is not there.
struct Trim {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX(), side = Eigen::Vector3d::UnitX();
  double radius = 0;
};

struct Patch {
  Shape shape;
  Pose T_part_patch = Pose::Identity();
  bool inward = false;  // the air is on the side of the axis, or below
  std::optional<Trim> trim = {};
};

// Everything below is in the patch's own frame.

// Distance (m) along the unit `direction` to the first hit, from either side, strictly between
// `near` and `far`.
[[nodiscard]] std::optional<double> first_hit(const Patch& patch, const Eigen::Vector3d& from,
                                              const Eigen::Vector3d& direction, double near,
                                              double far);
// Unit, towards the air.
[[nodiscard]] Eigen::Vector3d normal_at(const Patch& patch, const Eigen::Vector3d& point);
[[nodiscard]] Eigen::AlignedBox3d bounds(const Patch& patch);

// Area (m2) that sample() draws from; where it gives nothing, that share of it is not there.
[[nodiscard]] double sampled_area(const Patch& patch);
[[nodiscard]] std::optional<Eigen::Vector3d> sample(const Patch& patch, Random& random);

// False where a trim or a hole has taken away a point of the untrimmed surface.
[[nodiscard]] bool is_there(const Patch& patch, const Eigen::Vector3d& point);

}  // namespace spool::campaign
