// Which welds are rolled, against every order there is and against what is plain.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/roll_welds.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/vision/guide/small_spool.h"
#include "vision/guide/joint_ends.h"

namespace spool::test {
namespace {

// How far a part's ports and centre lie from a weld's axis at most: the small spool has no bodies.
double reach(const DesignModel& design, int part, const Joint& joint) {
  const auto axis =
      guide::place_of(design.parts[static_cast<std::size_t>(joint.part_a)], joint.port_a);
  const Part& own = design.parts[static_cast<std::size_t>(part)];
  double furthest =
      own.kind == PartKind::kElbow || own.kind == PartKind::kTee
          ? (own.T_design_part.translation() - axis.position).cross(axis.direction).norm()
          : 0;
  for (const Port& port : own.ports)
    furthest = std::max(
        furthest, (own.T_design_part * port.position - axis.position).cross(axis.direction).norm());
  return furthest;
}

// Welds that an order rolls where all that hangs together has to stay within the radius. Every weld
// of the small spool has a pipe or flange on its axis once its own two parts are joined, but the
// tee's and elbow's own do through their pipes too.
int rolled_by(const DesignModel& design, const std::vector<int>& order, double radius) {
  std::vector<int> group(design.parts.size());
  for (std::size_t p = 0; p < group.size(); ++p) group[p] = static_cast<int>(p);
  int rolled = 0;
  for (const int index : order) {
    const Joint& joint = design.joints[static_cast<std::size_t>(index)];
    const int from = group[static_cast<std::size_t>(joint.part_b)];
    const int to = group[static_cast<std::size_t>(joint.part_a)];
    for (int& each : group)
      if (each == from) each = to;
    bool fits = true;
    for (std::size_t p = 0; p < group.size(); ++p)
      fits = fits && (group[p] != to || reach(design, static_cast<int>(p), joint) <= radius);
    rolled += fits ? 1 : 0;
  }
  return rolled;
}

std::vector<int> joints_of(const guide::RollPlan& plan) {
  std::vector<int> order;
  for (const auto& each : plan.order) order.push_back(each.joint);
  return order;
}

TEST(RollWelds, NoOrderOfAllKeepsMore) {
  const DesignModel design = small_spool();
  for (const double radius : {0.2, 0.45, 0.6, 0.9, 1.2}) {
    const auto plan = guide::plan_roll_welds(design, {.swing_radius_m = radius});
    std::vector<int> order{0, 1, 2, 3, 4, 5, 6};
    int best = 0;
    do best = std::max(best, rolled_by(design, order, radius));
    while (std::next_permutation(order.begin(), order.end()));
    EXPECT_EQ(plan.rolled, best) << radius;
    EXPECT_EQ(rolled_by(design, joints_of(plan), radius), plan.rolled) << radius;
    EXPECT_TRUE(plan.is_best);
  }
}

TEST(RollWelds, FromTheFirstWeldOnIsWorse) {
  // As long as the branch is welded first, it hangs in the way of nothing but itself; from the
  // header's end on, the branch's own welds swing the whole header.
  const DesignModel design = small_spool();
  const auto plan = guide::plan_roll_welds(design, {.swing_radius_m = 0.6});
  EXPECT_GT(plan.rolled, rolled_by(design, {0, 1, 2, 3, 4, 5, 6}, 0.6));
}

TEST(RollWelds, SaysWhatWouldSwing) {
  const auto plan = guide::plan_roll_welds(small_spool(), {.swing_radius_m = 0.2});
  const auto fixed = std::find_if(plan.order.begin(), plan.order.end(),
                                  [](const auto& each) { return !each.can_roll; });
  ASSERT_NE(fixed, plan.order.end());
  EXPECT_NE(fixed->why_not.find("would swing"), std::string::npos) << fixed->why_not;
}

TEST(RollWelds, SiteAndYardWeldsAreMadeInPlaceAndLast) {
  DesignModel design = small_spool();
  design.joints[0].type = JointType::kField;
  design.joints[3].type = JointType::kYaw;
  const auto plan = guide::plan_roll_welds(design, {});
  ASSERT_EQ(plan.order.size(), 7U);
  EXPECT_EQ(plan.rolled, 5);
  EXPECT_EQ(plan.order[5].joint, 0);
  EXPECT_EQ(plan.order[6].joint, 3);
  EXPECT_FALSE(plan.order[6].can_roll);
}

TEST(RollWelds, ABranchOnAPipesSideIsNotRolled) {
  DesignModel design = small_spool();
  Part& run = design.parts[3];  // pipe_2, along x
  run.ports.push_back({"olet1", {0.4, 0, 0.057}, Eigen::Vector3d::UnitZ(), 1});
  Part olet;
  olet.name = "olet_1";
  olet.kind = PartKind::kOlet;
  olet.ports = {{"run", {0, 0, 0}, -Eigen::Vector3d::UnitZ(), 1},
                {"b", {0, 0, 0.03}, Eigen::Vector3d::UnitZ(), 1}};
  olet.T_design_part.translation() = Eigen::Vector3d(1.086, 0, 0.057);
  design.parts.push_back(olet);
  design.joints.push_back({"W8", 3, 2, 8, 0, JointType::kFab});
  const auto plan = guide::plan_roll_welds(design, {.swing_radius_m = 5});
  EXPECT_EQ(plan.rolled, 7);
  EXPECT_EQ(plan.order.back().joint, 7);
  EXPECT_EQ(plan.order.back().why_not, "branch weld on the side of pipe_2");
}

TEST(RollWelds, NeedsSomethingStraightToTurnItOn) {
  // A tee and an elbow, welded to each other alone.
  DesignModel design = small_spool();
  design.joints.clear();
  design.parts[6].T_design_part.translation() = Eigen::Vector3d(0.581, 0, 0.257);
  design.joints.push_back({"W1", 2, 2, 6, 0, JointType::kFab});
  const auto plan = guide::plan_roll_welds(design, {});
  ASSERT_EQ(plan.order.size(), 1U);
  EXPECT_EQ(plan.order[0].why_not, "nothing straight on its axis to turn it on");
}

}  // namespace
}  // namespace spool::test
