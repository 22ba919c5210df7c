// Where the next part belongs: on what was built, beside where the drawing has it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "vision/core/pose.h"
#include "vision/guide/assembly_step.h"

namespace spool::guide {

// A part as it was built and accepted. The covariance (m, rad) is of a small motion in the part's
// own frame: T_design_part(true) = T_design_part pose_from_small(motion), as pose_error in reports.
struct BuiltPose {
  int part = -1;
  Pose T_design_part = Pose::Identity();
  Matrix6d covariance = Matrix6d::Zero();
};

struct GhostPose {
  Pose T_design_part = Pose::Identity();     // where the part belongs on what stands
  Matrix6d covariance = Matrix6d::Zero();    // in the part's own frame there, as BuiltPose
  Pose T_design_nominal = Pose::Identity();  // the drawing's place
  // How far the ghost's joining port lies from the drawing's (m), and how much it is turned (rad).
  double distance_m = 0, u_distance_m = 0;
  double angle_rad = 0, u_angle_rad = 0;
  // How far two neighbours disagree on the place at worst (m, rad): a closure that will not close.
  double closure_m = 0, closure_rad = 0;
};

// The ghost of a step's part. Each standing neighbour says T_design_built
// inverse(T_design_neighbour) T_design_part; of several the mean by their covariances is taken.
// Neighbours that are not in `built` say nothing; where none is, there is no ghost: the base is put
// where it is put. Frames: design, metres. Pure; any thread.
[[nodiscard]] std::optional<GhostPose> ghost_pose(const DesignModel& design,
                                                  const AssemblyStep& step,
                                                  const std::vector<BuiltPose>& built);

// The adjoint of a pose for small motions, translation first: A pose_from_small(m) inverse(A) is
// pose_from_small(adjoint(A) m) to first order.
[[nodiscard]] Matrix6d adjoint(const Pose& pose);

}  // namespace spool::guide
