// What a step of the assembly is: the part, the joints it makes, its cut length and where it comes
// from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vision/guide/cut_length.h"
#include "vision/guide/joint_ends.h"

namespace spool::guide {

// A joint that a step makes with a part that stands.
struct StepJoint {
  JointEnd end;      // from the side of the part that comes
  std::string weld;  // its number; "" where none is known or nothing is welded
  JointType type = JointType::kFab;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // of the standing port, design frame, m
  // Unit, design frame: outward from the standing port. The part comes from there, against it.
  Eigen::Vector3d comes_from = Eigen::Vector3d::UnitZ();
};

struct AssemblyStep {
  int part = -1;
  std::vector<StepJoint> joints;  // none: the base, or the first of a group that nothing connects
  std::optional<CutLength> cut;   // of a pipe
};

// The steps of an order without faults (order_faults()), in the design frame. Pure; any thread.
[[nodiscard]] std::vector<AssemblyStep> assembly_steps(const DesignModel& design,
                                                       const std::vector<int>& order,
                                                       const GapPolicy& policy);

}  // namespace spool::guide
