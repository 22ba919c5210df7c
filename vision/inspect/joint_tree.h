// The design's joints as a tree from the datum outward: what hangs on each.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool {

// Where a joint is and which way it looks; m, design frame.
struct JointFrame {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  Eigen::Vector3f outward = Eigen::Vector3f::UnitZ();  // unit, from near to far
};

// Another joint that a branch could hang at by mistake.
struct OtherJoint {
  JointFrame frame;
  int joint = -1;  // of the design
};

// A joint, and all parts that are held by it alone, seen from the root.
struct JointBranch {
  int joint = -1;                     // of the design
  int part_near = -1, part_far = -1;  // nearer to the root, further
  JointFrame frame;                   // where they meet
  std::vector<int> parts;             // far one first
  std::vector<std::uint8_t> is_part;  // one a part of the design
  std::vector<OtherJoint> others;     // that it could hang at
  double most_shorter_m = 0;          // as much pipe as there is to cut off at the joint
  bool turns = true;                  // about its joint, and slides along it; else only hangs

  [[nodiscard]] bool holds(int part) const {
    return part >= 0 && is_part[static_cast<std::size_t>(part)] != 0;
  }
};

// The root is the first datum, else the first part. A joint in a loop holds nothing alone and is
// left out, and so is what no joint connects to the root. In breadth-first order.
[[nodiscard]] std::vector<JointBranch> joint_tree(const DesignModel& design);

// The parts on the way from one to the other through the tree, both included; those two alone where
// none leads.
[[nodiscard]] std::vector<int> parts_between(std::span<const JointBranch> tree, int a, int b);

// The same joints seen from beyond: of each what holds the datum, which is all but the branch. And
// of each two joints of one part, what remains without both branches: were they exchanged, it lies
// as if it hung at the other of the two.
[[nodiscard]] std::vector<JointBranch> datum_sides(const DesignModel& design);

}  // namespace spool
