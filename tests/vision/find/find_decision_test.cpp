// From evidence to what may be said: a table of cases, each with its reason.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/find_decision.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace spool {
namespace {

// As many runs of one part with joints on them, and after each but the last an elbow to the next;
// a flange on the first and on the last.
FinderModel chain(int count = 3) {
  FinderModel model;
  model.runs.count = count;
  for (int run = 0; run < count; ++run) {
    model.runs.of_part.push_back(run);
    model.runs.at.push_back({run});
    model.runs.lines.push_back({Eigen::Vector3f::Zero(), Eigen::Vector3f::Unit(run)});
  }
  for (int run = 0; run + 1 < count; ++run) {
    model.runs.of_part.push_back(-1);
    model.runs.at.push_back({run, run + 1});
  }
  for (const int run : {0, count - 1}) {
    model.runs.of_part.push_back(run);
    model.runs.at.push_back({run});
  }
  model.parts = model.runs.of_part.size();
  return model;
}

// Explains the points [from, to) of a scene, a third of them on each of three parts.
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

PoseEvidence with_parts(PoseEvidence pose, const std::vector<std::uint32_t>& per_part) {
  pose.per_part = per_part;
  return pose;
}

// Of chain(3): three runs, two elbows, a flange on either end.
PoseEvidence with_stops(PoseEvidence pose, const std::vector<std::uint8_t>& shows_stop) {
  pose.shows_stop = shows_stop;
  return pose;
}

PoseEvidence loose(PoseEvidence pose, int free_motions) {
  pose.free_motions = free_motions;
  return pose;
}

PoseEvidence sighted(PoseEvidence pose, std::size_t there, std::size_t through) {
  pose.sighted = {there, through, 0};
  return pose;
}

PoseEvidence behind(PoseEvidence pose, double share) {
  pose.behind = share;
  return pose;
}

struct Case {
  const char* name;
  std::vector<PoseEvidence> poses;
  bool found;
  std::vector<std::size_t> others;
  const char* reason;  // part of it
};

class Decisions : public testing::TestWithParam<Case> {};

TEST_P(Decisions, FollowTheEvidence) {
  const FindDecision decision = decide(chain(), GetParam().poses);
  EXPECT_EQ(decision.found, GetParam().found) << decision.reason;
  if (GetParam().found) {
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
        Case{"nothing_was_tried", {}, false, {}, "was not found"},
        Case{"nothing_was_explained", {PoseEvidence{}}, false, {}, "explains 0 %"},
        Case{"one_clear_pose", {evidence(0, 1000, 0.6)}, true, {}, ""},
        // Under a third of the design: a run of pipe is as much of many spools.
        Case{"a_quarter_of_the_design", {evidence(0, 1000, 0.25)}, false, {}, "explains 25 %"},
        // Half of what it explains would lie there by chance.
        Case{"amid_clutter", {evidence(0, 1000, 0.6, 500)}, false, {}, "among clutter"},
        Case{"few_points_of_which_some_are_chance",
             {evidence(0, 40, 0.6, 6)},
             false,
             {},
             "among clutter"},
        Case{"it_slides", {loose(evidence(0, 1000, 0.6), 1)}, false, {}, "hold it in place"},
        // Two copies, or a design that resembles itself: both are named.
        Case{"two_as_good", {evidence(0, 1000, 0.6), evidence(2000, 2995, 0.6)}, true, {1}, ""},
        Case{"a_second_best", {evidence(0, 1000, 0.6), evidence(0, 700, 0.4)}, true, {}, ""},
        // With less than half of the design in sight, a near rival leaves it open.
        Case{"a_rival_of_a_part_seen",
             {evidence(0, 1000, 0.4), evidence(0, 850, 0.35)},
             false,
             {},
             "several places"},
        Case{"a_rival_of_a_part_seen_far_behind",
             {evidence(0, 1000, 0.4), evidence(0, 750, 0.35)},
             true,
             {},
             ""},
        // A camera saw what lies behind most of it; a third of it may well be missing.
        Case{"seen_through",
             {sighted(evidence(0, 1000, 0.6), 100, 120)},
             false,
             {},
             "saw what lies behind"},
        Case{"a_third_seen_through", {sighted(evidence(0, 1000, 0.6), 200, 100)}, true, {}, ""},
        Case{"a_rival_that_was_seen_through",
             {evidence(0, 1000, 0.4), sighted(evidence(0, 990, 0.4), 300, 100)},
             true,
             {},
             ""},
        // Nobody can have scanned what lies below the floor; a spool may go through a wall.
        Case{"below_the_floor",
             {behind(evidence(0, 1000, 0.45), 0.55)},
             false,
             {},
             "behind floor or walls"},
        Case{"through_a_wall", {behind(evidence(0, 1000, 0.6), 0.4)}, true, {}, ""},
        Case{"a_rival_that_reaches_through_the_floor",
             {evidence(0, 1000, 0.4), behind(evidence(0, 990, 0.4), 0.25)},
             true,
             {},
             ""},
        // Two of the design's three runs, and little of the whole: any two pipes look so.
        Case{"two_pipes_that_meet",
             {with_parts(evidence(0, 1000, 0.4), {500, 480, 20})},
             false,
             {},
             "two pipes that meet"},
        Case{"two_pipes_that_are_most_of_it",
             {with_parts(evidence(0, 1000, 0.72), {500, 480, 20})},
             true,
             {},
             ""},
        // With a flange on one of them: its length agrees by chance now and then.
        Case{
            "two_pipes_and_a_flange",
            {with_stops(with_parts(evidence(0, 1000, 0.6), {500, 480, 20}), {0, 0, 0, 1, 0, 1, 0})},
            false,
            {},
            "two pipes that meet"},
        // A length of either, as of a flange and an elbow on each side.
        Case{
            "two_pipes_of_two_lengths_that_agree",
            {with_stops(with_parts(evidence(0, 1000, 0.5), {500, 480, 20}), {0, 0, 0, 1, 1, 1, 0})},
            true,
            {},
            ""},
        Case{
            "two_pipes_of_two_lengths_and_little_of_the_whole",
            {with_stops(with_parts(evidence(0, 1000, 0.4), {500, 480, 20}), {0, 0, 0, 1, 1, 1, 0})},
            false,
            {},
            "two pipes that meet"},
        Case{"one_run_with_a_flange_and_an_elbow",
             {with_stops(with_parts(evidence(0, 1000, 0.5), {960, 20, 20}), {0, 0, 0, 1, 0, 1, 0})},
             false,
             {},
             "two pipes that meet"},
        Case{
            "three_runs_of_it", {with_parts(evidence(0, 1000, 0.4), {500, 440, 60})}, true, {}, ""},
        Case{"ten_as_good",
             std::vector<PoseEvidence>(10, evidence(0, 1000, 0.6)),
             false,
             {},
             "several places"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(FindDecision, LetsABodyOfRevolutionTurn) {
  FinderModel model = chain();
  const std::vector<PoseEvidence> poses = {loose(evidence(0, 1000, 0.6), 1)};
  EXPECT_FALSE(decide(model, poses).found);
  model.free_motions = 1;
  EXPECT_TRUE(decide(model, poses).found);
}

TEST(FindDecision, AsksOfADesignNoMoreRunsThanItHas) {
  const auto is_found = [](int runs, const PoseEvidence& pose) {
    return decide(chain(runs), {pose}).found;
  };
  EXPECT_TRUE(is_found(1, with_parts(evidence(0, 1000, 0.32), {1000, 0, 0})));
  const std::vector<std::uint32_t> both{500, 500}, one{990, 10};
  EXPECT_TRUE(is_found(2, with_parts(evidence(0, 1000, 0.5), both)));
  EXPECT_FALSE(is_found(2, with_parts(evidence(0, 1000, 0.4), both)));
  EXPECT_TRUE(is_found(2, with_stops(with_parts(evidence(0, 1000, 0.4), both), {0, 0, 1, 1, 1})));
  EXPECT_FALSE(is_found(2, with_parts(evidence(0, 1000, 0.5), one)));
  // Of runs that are no line of joints nobody knows where they stop.
  FinderModel bare = chain(2);
  bare.runs.lines.assign(2, {});
  EXPECT_TRUE(decide(bare, {with_parts(evidence(0, 1000, 0.4), both)}).found);
}

TEST(FindDecision, NeedsNoParts) {
  FinderModel model;
  PoseEvidence a = evidence(0, 1000, 0.6), b = evidence(2000, 2600, 0.6);
  a.per_part.clear();
  b.per_part.clear();
  const FindDecision decision = decide(model, {a, b});
  EXPECT_TRUE(decision.found);
}

}  // namespace
}  // namespace spool
