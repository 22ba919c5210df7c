// The camera of a BCF viewpoint: metres, z up, from where a picture of the report is seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spool::ncr {

// Vertical, degrees: what BCF 2.1 allows is 45 to 60.
inline constexpr double kFieldOfView_deg = 60;

struct BcfCamera {
  Eigen::Vector3d view_point = Eigen::Vector3d::Zero();  // m, z up
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  // unit, into the picture
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();         // unit, at right angles to direction
};

// BCF is z up; glTF is y up by its standard, and so is our design frame: (x, y, z) becomes
// (x, -z, y), a turn of 90 degrees about x. Of a PCF that is east, north, up. Points and directions
// alike, m.
[[nodiscard]] Eigen::Vector3d z_up(const Eigen::Vector3d& design);

// "seen from +x -y" (a caption of the report): the unit direction out of the design to the eye,
// design frame; nothing of another text.
[[nodiscard]] std::optional<Eigen::Vector3d> eye_side(const std::string& caption);

// A camera on that side that has all of `bounds` (m, the design file's coordinates) in its picture,
// however wide that is from square on.
[[nodiscard]] BcfCamera camera_at(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& side);

}  // namespace spool::ncr
