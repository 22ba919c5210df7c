// The order of assembly: what is proposed, what can be changed, what is told as impossible.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/assembly_order.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/vision/guide/small_spool.h"
#include "vision/guide/assembly_step.h"

namespace spool::test {
namespace {

using guide::assembly_steps;
using guide::move_step;
using guide::order_faults;
using guide::propose_order;
using Names = std::vector<std::string>;

TEST(AssemblyOrder, GoesFromTheDatumOutward) {
  DesignModel design = small_spool();
  design.datums = {part_named(design, "flange_2")};
  EXPECT_EQ(
      names_of(design, propose_order(design)),
      (Names{"flange_2", "pipe_2", "tee_1", "pipe_1", "pipe_3", "flange_1", "elbow_1", "pipe_4"}));
}

TEST(AssemblyOrder, WithoutDatumStartsAtAFlangeOfTheHeaviestRun) {
  DesignModel design = small_spool();
  EXPECT_EQ(guide::base_part(design), part_named(design, "flange_1"));
  // With a cap for the flange on the first end, the run's other end is its flange.
  DesignModel capped = small_spool();
  capped.parts[static_cast<std::size_t>(part_named(capped, "flange_1"))].kind = PartKind::kCap;
  EXPECT_EQ(guide::base_part(capped), part_named(capped, "flange_2"));
  // One bore larger and long enough, the branch is heavier; its open end turns off at the elbow.
  Part& branch = design.parts[static_cast<std::size_t>(part_named(design, "pipe_3"))];
  branch.nps = 24;
  EXPECT_EQ(guide::base_part(design), part_named(design, "pipe_3"));
  EXPECT_TRUE(order_faults(design, propose_order(design)).empty());
}

TEST(AssemblyOrder, PutsSiteJointsAfterShopWelds) {
  DesignModel design = small_spool();
  design.datums = {part_named(design, "flange_1")};
  design.joints[2].type = JointType::kField;  // W3: the tee to pipe_2
  EXPECT_EQ(
      names_of(design, propose_order(design)),
      (Names{"flange_1", "pipe_1", "tee_1", "pipe_3", "elbow_1", "pipe_4", "pipe_2", "flange_2"}));
}

TEST(AssemblyOrder, TakesTheDesignsOwnWhereItCanBeBuilt) {
  DesignModel design = small_spool();
  const Names own{"tee_1",  "pipe_3",   "elbow_1", "pipe_4",
                  "pipe_1", "flange_1", "pipe_2",  "flange_2"};
  for (std::size_t s = 0; s < own.size(); ++s)
    design.parts[static_cast<std::size_t>(part_named(design, own[s]))].order = static_cast<int>(s);
  EXPECT_EQ(names_of(design, propose_order(design)), own);
  std::swap(design.parts[static_cast<std::size_t>(part_named(design, "elbow_1"))].order,
            design.parts[static_cast<std::size_t>(part_named(design, "pipe_4"))].order);
  EXPECT_EQ(names_of(design, propose_order(design)).front(), "flange_1");
}

TEST(AssemblyOrder, EveryStepJoinsWhatStandsFromOutside) {
  const DesignModel design = small_spool();
  const auto steps = assembly_steps(design, propose_order(design), {});
  ASSERT_EQ(steps.size(), 8u);
  EXPECT_TRUE(steps[0].joints.empty());
  for (std::size_t s = 1; s < steps.size(); ++s) ASSERT_EQ(steps[s].joints.size(), 1u) << s;
  for (const auto& step : steps) {
    if (step.part != part_named(design, "pipe_3")) continue;
    EXPECT_EQ(step.joints[0].weld, "W5");
    EXPECT_EQ(step.joints[0].end.neighbour, part_named(design, "tee_1"));
    EXPECT_TRUE(step.joints[0].comes_from.isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(step.joints[0].place.isApprox(Eigen::Vector3d(0.581, 0, 0.105)));
    EXPECT_TRUE(step.cut.has_value());
  }
}

TEST(AssemblyOrder, AStepCanBeMovedWhereItStillJoins) {
  DesignModel design = small_spool();
  design.datums = {part_named(design, "flange_1")};
  const auto order = propose_order(design);
  // flange_1 pipe_1 tee_1 pipe_2 pipe_3 flange_2 elbow_1 pipe_4
  const auto moved = move_step(design, order, 3, 6);
  ASSERT_FALSE(moved) << "flange_2 would come before the pipe that carries it";
  const auto fine = move_step(design, order, 5, 7);
  ASSERT_TRUE(fine);
  EXPECT_EQ(names_of(design, *fine).back(), "flange_2");
}

TEST(AssemblyOrder, AMoveThatJoinsNothingIsRefusedWithItsReason) {
  DesignModel design = small_spool();
  design.datums = {part_named(design, "flange_1")};
  const auto order = propose_order(design);
  expect_refused(move_step(design, order, 7, 1), ErrorCode::kUsage, "pipe_4",
                 "it joins elbow_1, which comes later");
  expect_refused(move_step(design, order, 8, 1), ErrorCode::kUsage, "", "steps 1 to 8");
  expect_refused(move_step(design, order, 1, -1), ErrorCode::kUsage, "", "steps 1 to 8");
}

TEST(AssemblyOrder, TellsPartsThatAreMissingTwiceOrUnknown) {
  const DesignModel design = small_spool();
  auto order = propose_order(design);
  const int last = order.back();
  order.back() = order[1];
  auto faults = order_faults(design, order);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].step, 7);
  EXPECT_NE(faults[0].reason.find("stands already"), std::string::npos);
  EXPECT_NE(faults[1].reason.find("is in no step"), std::string::npos);
  order.back() = last;
  order.push_back(99);
  faults = order_faults(design, order);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].reason.find("no part 99"), std::string::npos);
}

TEST(AssemblyOrder, WhatNothingConnectsComesLastAndIsNoFault) {
  DesignModel design = small_spool();
  Part support;
  support.name = "support_1";
  support.kind = PartKind::kSupport;
  design.parts.insert(design.parts.begin(), support);
  for (Joint& joint : design.joints) {
    ++joint.part_a;
    ++joint.part_b;
  }
  const auto order = propose_order(design);
  EXPECT_EQ(names_of(design, order).back(), "support_1");
  EXPECT_TRUE(order_faults(design, order).empty());
}

TEST(AssemblyOrder, OfNothingIsEmpty) {
  EXPECT_EQ(guide::base_part({}), -1);
  EXPECT_TRUE(propose_order({}).empty());
}

}  // namespace
}  // namespace spool::test
