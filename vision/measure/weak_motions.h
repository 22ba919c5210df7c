// Which motions a covariance leaves open, in words where they are known ones.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/core/pose.h"
#include "vision/inspect/part_pose.h"

namespace spool {

// A motion (m, rad) that may be open, and what to call it.
struct NamedMotion {
  Vector6d motion = Vector6d::Zero();
  std::string text;
};

// Unit motions at the origin of the frame that `frame` is given in: along one of its axes, and
// about its z.
[[nodiscard]] Vector6d shift_along(const Pose& frame, int axis);
[[nodiscard]] Vector6d turn_about(const Pose& frame);

// The space in which a standard deviation is over a tenth (m, rad) of kUnobservedSigma, as unit
// directions: first the named motions that lie in it, in their order and each only as far as those
// before it do not span it, then what is left of it.
[[nodiscard]] std::vector<WeakMotion> weak_motions(const Matrix6d& covariance,
                                                   const std::vector<NamedMotion>& named);

}  // namespace spool
