// Which unit a file without one is in, and how its coordinates become metres near an origin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/length_unit.h"
#include "vision/core/point_cloud.h"

namespace spool {

// The box that holds all but the outermost half percent of the finite points on each side of each
// axis: a few stray readings say nothing about a scan's size. Empty without a finite point.
[[nodiscard]] Eigen::AlignedBox3d robust_box(std::span<const Eigen::Vector3d> points);

// The unit that makes `extent` (the diagonal of the robust box, in the file's unit) the size of a
// scan of a workplace with a spool in it: 2 cm to 150 m. Metres are tried first, as point-cloud
// files are by convention:
//   0.02 to 150     metres
//   300 to 60 000   millimetres (0.3 to 60 m; as inches it would be a plant)
// Nothing for all else. Between the two a site in metres and a small part in millimetres look
// alike. Inches are never inferred: every inch cloud has a size that one of the others explains as
// well.
[[nodiscard]] std::optional<LengthUnit> unit_for_extent(double extent);

// Floats lose more than 10 micrometres from here on (half their step is 15 there).
inline constexpr double kFloatReach = 256.0;  // m

// Points (file's unit) as metres, those not finite as NaN in all three. Where a coordinate reaches
// kFloatReach the cloud's origin is the median of its coordinates in whole metres.
void set_points(PointCloud& cloud, std::span<const Eigen::Vector3d> points, LengthUnit unit);

}  // namespace spool
