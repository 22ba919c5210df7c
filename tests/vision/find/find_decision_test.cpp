// From evidence to what may be said: a table of cases, each with its reason.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/find_decision.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace spool {
namespace {

// Three parts in a chain; the first is the datum.
FinderModel chain() {
  FinderModel model;
  model.parts = 3;
  model.joints = {{0, 1}, {1, 2}};
  model.datums = {0};
  return model;
}

// Explains the points [from, to) of a scene, a third of them on each part.
PoseEvidence evidence(std::uint32_t from, std::uint32_t to, double coverage, double chance = 0) {
  PoseEvidence pose;
  pose.points.resize(to - from);
  std::iota(pose.points.begin(), pose.points.end(), from);
  pose.explained = pose.points.size();
  pose.coverage = coverage;
  pose.chance = chance;
  pose.per_part.assign(3, (to - from) / 3);
  return pose;
}

PoseEvidence on_parts(std::uint32_t from, const std::vector<std::uint32_t>& per_part) {
  const std::uint32_t count = std::accumulate(per_part.begin(), per_part.end(), 0U);
  PoseEvidence pose = evidence(from, from + count, 0.6);
  pose.per_part = per_part;
  return pose;
}

PoseEvidence loose(PoseEvidence pose, int free_motions) {
  pose.free_motions = free_motions;
  return pose;
}

struct Case {
  const char* name;
  std::vector<PoseEvidence> poses;
  bool found;
  std::size_t best;
  std::vector<std::size_t> others;
  const char* reason;  // part of it
};

class Decisions : public testing::TestWithParam<Case> {};

TEST_P(Decisions, FollowTheEvidence) {
  const FindDecision decision = decide(chain(), GetParam().poses);
  EXPECT_EQ(decision.found, GetParam().found) << decision.reason;
  if (GetParam().found) {
    EXPECT_EQ(decision.best, GetParam().best);
    EXPECT_EQ(decision.others, GetParam().others);
    EXPECT_TRUE(decision.reason.empty()) << decision.reason;
  } else {
    EXPECT_NE(decision.reason.find(GetParam().reason), std::string::npos) << decision.reason;
    EXPECT_TRUE(decision.others.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Evidence, Decisions,
    testing::Values(
        Case{"nothing_was_tried", {}, false, 0, {}, "was not found"},
        Case{"nothing_was_explained", {PoseEvidence{}}, false, 0, {}, "explains 0 %"},
        Case{"one_clear_pose", {evidence(0, 1000, 0.6)}, true, 0, {}, ""},
        // Under a third of the design: a run of pipe is as much of many spools.
        Case{"a_quarter_of_the_design", {evidence(0, 1000, 0.25)}, false, 0, {}, "explains 25 %"},
        // Half of what it explains would lie there by chance.
        Case{"amid_clutter", {evidence(0, 1000, 0.6, 500)}, false, 0, {}, "among clutter"},
        Case{"few_points_of_which_some_are_chance",
             {evidence(0, 40, 0.6, 6)},
             false,
             0,
             {},
             "among clutter"},
        Case{"it_slides", {loose(evidence(0, 1000, 0.6), 1)}, false, 0, {}, "hold it in place"},
        // Two copies, or a design that resembles itself: both are named.
        Case{"two_as_good", {evidence(0, 1000, 0.6), evidence(2000, 2995, 0.6)}, true, 0, {1}, ""},
        Case{"a_second_best", {evidence(0, 1000, 0.6), evidence(0, 700, 0.4)}, true, 0, {}, ""},
        // With less than half of the design in sight, a near rival leaves it open.
        Case{"a_rival_of_a_part_seen",
             {evidence(0, 1000, 0.4), evidence(0, 850, 0.35)},
             false,
             0,
             {},
             "several places"},
        Case{"a_rival_of_a_part_seen_far_behind",
             {evidence(0, 1000, 0.4), evidence(0, 750, 0.35)},
             true,
             0,
             {},
             ""},
        Case{"ten_as_good",
             std::vector<PoseEvidence>(10, evidence(0, 1000, 0.6)),
             false,
             0,
             {},
             "several places"},
        // The middle part and the last are elsewhere: one joint wrong. The best explains the arm,
        // which takes the joint to the datum to be wrong; the second holds the datum. One joint
        // either way: the datum decides.
        Case{"the_datum_decides",
             {on_parts(0, {0, 600, 500}), on_parts(2000, {700, 0, 0})},
             true,
             1,
             {},
             ""},
        // The best is out at two joints (the middle part alone), the other at one.
        Case{"fewest_joints_wrong",
             {on_parts(0, {0, 900, 0}), on_parts(2000, {0, 0, 500}), on_parts(4000, {400, 0, 0})},
             true,
             2,
             {},
             ""}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(FindDecision, LetsABodyOfRevolutionTurn) {
  FinderModel model = chain();
  const std::vector<PoseEvidence> poses = {loose(evidence(0, 1000, 0.6), 1)};
  EXPECT_FALSE(decide(model, poses).found);
  model.free_motions = 1;
  EXPECT_TRUE(decide(model, poses).found);
}

TEST(FindDecision, NeedsNoPartsJointsOrDatums) {
  FinderModel model;
  PoseEvidence a = evidence(0, 1000, 0.6), b = evidence(2000, 2600, 0.6);
  a.per_part.clear();
  b.per_part.clear();
  const FindDecision decision = decide(model, {a, b});
  EXPECT_TRUE(decision.found);
  EXPECT_EQ(decision.best, 0U);
}

}  // namespace
}  // namespace spool
