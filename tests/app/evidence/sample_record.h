// A small inspection made by hand: two boxes, a few points each, every kind of point and status.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "app/evidence/inspection_record.h"

namespace spool::test {

// Appends an axis-parallel box (m) as a part of `model`.
void add_box(DesignModel& model, const std::string& name, const Eigen::Vector3d& low,
             const Eigen::Vector3d& high);

// Surface and samples over `model`.
[[nodiscard]] std::shared_ptr<const PreparedDesign> prepared(DesignModel model);

// Parts "base" (on top of it points 2 mm outside) and "post" (not seen); the scan also has one NaN,
// one clutter and one contradicting point. Five points a millimetre-exact value each, in this
// order: base, base, NaN, clutter, contradicting (post).
[[nodiscard]] evidence::InspectionRecord sample_record();

// A length that is too long, an angle that cannot be told, a face that was not seen.
[[nodiscard]] std::vector<Dimension> sample_dimensions();

}  // namespace spool::test
