// The surface that a pipe would have beyond its end, were it too long.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/inspect/joint_tree.h"

namespace spool {

// A place on it, and how far (m) beyond the joint.
struct PipeEndPoint {
  Eigen::Vector3f point;  // m, design frame
  float along;
};

// As dense as the samples are, the nearest to the joint first: the pipe before the joint, mirrored
// in it, or the one behind it, which would then begin further out. Nothing where neither is a pipe.
[[nodiscard]] std::vector<PipeEndPoint> pipe_end(const DesignModel& design,
                                                 const JointBranch& branch,
                                                 const SurfaceSamples& samples);

}  // namespace spool
