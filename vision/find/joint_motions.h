// Where the design would lie were one joint turned or one pipe too long: other pieces of the spool.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/design/design_model.h"
#include "vision/find/occupancy.h"

namespace spool {

// A line that joints lie on; m, design frame.
struct JointAxis {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  Eigen::Vector3f direction = Eigen::Vector3f::UnitZ();  // unit
};

// The axes of the design's joints, those in one line once.
[[nodiscard]] std::vector<JointAxis> joint_axes(const DesignModel& design);

// What a spool is built wrong by, told from its best pose: the design turned about each axis by any
// angle and slid along it by up to `slide_m`, where that meets scan points; the most promising few
// of each axis. `probes`: design samples (m).
[[nodiscard]] std::vector<Eigen::Isometry3f> joint_motions(std::span<const JointAxis> axes,
                                                           const Eigen::Isometry3f& T_design_scan,
                                                           const Occupancy& occupancy,
                                                           std::span<const Eigen::Vector3f> probes,
                                                           double slide_m);

}  // namespace spool
