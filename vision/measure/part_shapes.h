// What a part's mesh says of its shape where semantics do not: a pipe's radius, a flange's face.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool {

// A pipe between its first two ports.
struct PipeShape {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  // m, design frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit
  double length_m = 0, radius_m = 0;                // outside
  double bore_radius_m = 0;                         // 0: not drawn
};
// Nothing where the part is no pipe, has no two ports or no mesh.
[[nodiscard]] std::optional<PipeShape> pipe_shape(const DesignModel& design, int part);

// Standard deviation (m) of an outside radius: half of what ASTM A999 lets the diameter be off, as
// a rectangle.
[[nodiscard]] double mill_radius_u(double radius_m);

// By how much (m) an outside diameter may differ before the pipe is of another nominal size: 4 %,
// as neighbours of ASME B36.10 differ by 8 % at least.
[[nodiscard]] double size_tolerance_m(double radius_m);

// The raised face of a flange or blind.
struct FaceShape {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // m, design frame: the face port
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, outward
  double face_diameter_m = 0;                         // of the foremost plane
  double flange_radius_m = 0;
  std::vector<double> levels;  // m, along the normal from the port, of planes that look forward
};
// Nothing where the part has no face port or no plane there.
[[nodiscard]] std::optional<FaceShape> face_shape(const DesignModel& design, int part);

}  // namespace spool
