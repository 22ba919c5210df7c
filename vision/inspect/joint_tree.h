// The design's joints as a tree from the datum outward: what hangs on each.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool {

// A joint, and all parts that are held by it alone, seen from the datum.
struct JointBranch {
  int joint = -1;                                      // of the design
  int part_near = -1, part_far = -1;                   // nearer to the datum, further
  Eigen::Vector3f point = Eigen::Vector3f::Zero();     // m, design frame: where they meet
  Eigen::Vector3f outward = Eigen::Vector3f::UnitZ();  // unit, from near to far
  std::vector<int> parts;                              // far one first
  std::vector<std::uint8_t> is_part;                   // one a part of the design

  [[nodiscard]] bool holds(int part) const {
    return part >= 0 && is_part[static_cast<std::size_t>(part)] != 0;
  }
};

// The root is the first datum, else the first part. A joint in a loop holds nothing alone and is
// left out, and so is what no joint connects to the root. In breadth-first order.
[[nodiscard]] std::vector<JointBranch> joint_tree(const DesignModel& design);

}  // namespace spool
