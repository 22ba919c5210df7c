// Tests of the tree of joints: the parts on the way from one to another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/joint_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"

namespace spool {
namespace {

std::vector<int> sorted_between(const std::vector<JointBranch>& tree, int a, int b) {
  std::vector<int> parts = parts_between(tree, a, b);
  std::ranges::sort(parts);
  return parts;
}

TEST(PartsBetween, AreThoseThatJointsLeadThroughAndNoOthers) {
  using enum test::JointedPart;
  const std::vector<JointBranch> tree = joint_tree(test::jointed().design);
  EXPECT_EQ(sorted_between(tree, kRiser, kTip), (std::vector<int>{kRiser, kArm, kTip}));
  // Over the root, from one branch into another.
  EXPECT_EQ(sorted_between(tree, kTip, kEnd), (std::vector<int>{kRiser, kArm, kTip, kSide, kEnd}));
  EXPECT_EQ(sorted_between(tree, kArm, kArm), std::vector<int>{kArm});
}

TEST(PartsBetween, AreTheTwoAloneWhereNoJointLeads) {
  EXPECT_EQ(parts_between({}, 3, 1), (std::vector<int>{3, 1}));
}

}  // namespace
}  // namespace spool
