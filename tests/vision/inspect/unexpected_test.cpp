// A branch too many is told from a stand, from what only lies near, and from the sensor's fringe.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/unexpected.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"
#include "vision/inspect/spool_findings.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::jointed;
using test::Rod;

// So far to each side of the middle the floor was scanned (m): further than the spool is long, or
// only round it, where it is no longer than the spool.
constexpr float kWide = 1.5F, kNarrow = 0.55F, kNoFloor = 0;

// The spool 0.2 m over a floor, as designed, and rods that are not the design's.
std::vector<Unexpected> unexpected_with(const std::vector<Rod>& more, float floor = kWide) {
  PointCloud scan =
      jointed().scan(jointed().as_designed(), std::vector<bool>(jointed().rods.size(), true));
  std::mt19937 random{11};
  for (const Rod& rod : more) {
    const PointCloud points = test::scan_of(
        {rod}, Pose::Identity(),
        {.points = static_cast<std::size_t>(75000 * rod.radius * rod.length), .noise_m = 0.001},
        random);
    scan.points.insert(scan.points.end(), points.points.begin(), points.points.end());
    scan.normals.insert(scan.normals.end(), points.normals.begin(), points.normals.end());
  }
  std::uniform_real_distribution<float> in(-floor, floor);
  for (int i = 0; i < 60000 && floor > 0; ++i) {
    scan.points.emplace_back(in(random), in(random), -0.2F);
    scan.normals.emplace_back(Eigen::Vector3f::UnitZ());
  }
  const ExplainedScan explained{scan, 0.001, true};
  Explanation explanation = explain_surface(jointed().explained(), explained);
  EXPECT_EQ(explanation.planes.empty(), floor < kWide);
  explain_pieces(jointed().explained(), explained, {}, explanation);
  EXPECT_TRUE(explanation.pieces.empty());
  std::size_t points = 0;
  for (const Unexpected& it : explanation.unexpected) points += it.points.size();
  EXPECT_EQ(explanation.declutter.contradicting, points);
  return explanation.unexpected;
}

TEST(Unexpected, IsNoneOnASpoolAsDesigned) { EXPECT_TRUE(unexpected_with({}).empty()); }

class BranchTooMany : public testing::TestWithParam<Rod> {};

TEST_P(BranchTooMany, IsFoundOnItsPart) {
  const auto found = unexpected_with({GetParam()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].part, test::kRiser);
  EXPECT_NEAR(found[0].reach_m, GetParam().length, 0.03);
  // All of it but what is within the surface's reach.
  EXPECT_GT(static_cast<double>(found[0].points.size()),
            0.8 * 75000 * GetParam().radius * GetParam().length * 0.8);
}

INSTANTIATE_TEST_SUITE_P(Directions, BranchTooMany,
                         testing::Values(Rod{{-0.03, 0, 0.6}, -Vector3d::UnitX(), 0.02, 0.25},
                                         Rod{{0.03, 0, 0.5}, Vector3d::UnitX(), 0.02, 0.12},
                                         // Level, and nearer to the floor than half of its reach.
                                         Rod{{-0.03, 0, 0.04}, -Vector3d::UnitX(), 0.02, 0.5}),
                         [](const auto& row) {
                           return row.index == 0 ? "back" : row.index == 1 ? "ahead" : "low";
                         });

// Half way between level and upright, with its end on the floor: nothing stands like that.
TEST(Unexpected, MayMeetTheFloorAslant) {
  const Rod branch{{0.02, 0, 0.2}, Vector3d(1, 0, -1).normalized(), 0.02, 0.55};
  const auto found = unexpected_with({branch});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].part, test::kRiser);
  EXPECT_GT(found[0].reach_m, 0.35);
}

// What leans against the spool from the floor has its line beside the steel.
TEST(Unexpected, IsNotWhatLeansOnTheSpool) {
  const Vector3d top(0, -0.052, 0.3), foot(0.5, -0.052, -0.2);
  EXPECT_TRUE(
      unexpected_with({{foot, (top - foot).normalized(), 0.02, (top - foot).norm()}}).empty());
}

TEST(Unexpected, IsNoLongThingThatOnlyLiesOnTheSpool) {
  EXPECT_TRUE(unexpected_with({{{0.3, -0.6, 0.852}, Vector3d::UnitY(), 0.02, 1.2}}).empty());
}

TEST(Unexpected, IsNotWhatHoldsTheSpoolUp) {
  // A jack under the arm, from the floor; and one of which the scanner saw the upper half.
  for (const float floor : {kWide, kNarrow}) {
    SCOPED_TRACE(floor);
    EXPECT_TRUE(
        unexpected_with({{{0.3, 0, -0.2}, Vector3d::UnitZ(), 0.025, 0.965}}, floor).empty());
    EXPECT_TRUE(
        unexpected_with({{{0.3, 0, 0.35}, Vector3d::UnitZ(), 0.025, 0.415}}, floor).empty());
  }
}

// Its farthest point lies 20 degrees beside its nearest one.
TEST(Unexpected, IsNoWidePostOfWhichTheLowerHalfIsHidden) {
  EXPECT_TRUE(unexpected_with({{{0.3, 0, 0.43}, Vector3d::UnitZ(), 0.06, 0.335}}).empty());
}

// Both are joined to the riser, and there to each other.
TEST(Unexpected, IsNotHeldByAStandBesideIt) {
  const Rod stand{{0, -0.055, -0.2}, Vector3d::UnitZ(), 0.025, 0.45};
  const Rod branch{{-0.03, 0, 0.1}, -Vector3d::UnitX(), 0.025, 0.25};
  const auto found = unexpected_with({stand, branch});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].reach_m, 0.25, 0.03);
}

TEST(Unexpected, IsNotWhatOnlyLiesNear) {
  EXPECT_TRUE(unexpected_with({{{-0.4, -0.3, 0.6}, Vector3d::UnitY(), 0.03, 0.5}}).empty());
}

TEST(Unexpected, IsNotAWeldOrALug) {
  EXPECT_TRUE(unexpected_with({{{-0.03, 0, 0.6}, -Vector3d::UnitX(), 0.01, 0.05}}).empty());
}

TEST(Unexpected, NeedsNoFloor) {
  EXPECT_EQ(unexpected_with({{{-0.03, 0, 0.6}, -Vector3d::UnitX(), 0.02, 0.25}}, kNoFloor).size(),
            1U);
}

TEST(Unexpected, IsNotWhatStandsOnAFloorThatWasCutOff) {
  const Rod jack{{0.3, 0, -0.2}, Vector3d::UnitZ(), 0.025, 0.965};
  EXPECT_EQ(unexpected_with({jack}, kNoFloor).size(), 1U) << "nothing else ends there";
  std::vector<Rod> more{jack};
  for (int i = 0; i < 8; ++i)
    more.push_back({{-1 + 0.6 * (i % 4), i < 4 ? -0.9 : 0.9, -0.2}, Vector3d::UnitZ(), 0.08, 0.5});
  EXPECT_TRUE(unexpected_with(more, kNoFloor).empty());
}

TEST(Unexpected, IsNotHeldWhereTheFloorHasEnded) {
  // Nearly as low as the floor, half a metre beyond its edge.
  const Rod branch{{0.6, 0, 0.95}, Vector3d(0.6, 0, -1.1).normalized(), 0.02, 1.26};
  EXPECT_TRUE(unexpected_with({branch}).empty());
  EXPECT_EQ(unexpected_with({branch}, kNarrow).size(), 1U);
}

TEST(Unexpected, IsAFindingAndMakesItsPartSuspicious) {
  Unexpected it;
  it.part = test::kArm;
  it.reach_m = 0.215;
  it.points = {1, 2, 3};
  std::vector<PartFinding> parts(6);
  const auto findings = spool_findings(jointed().design, {}, {it}, {}, parts);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, "unexpected");
  EXPECT_EQ(findings[0].part, "arm");
  EXPECT_EQ(findings[0].text,
            "Something that the design does not have sticks out of arm by 215 mm.");
  judge_unexpected(jointed().design, {it}, parts);
  EXPECT_EQ(parts[test::kArm].status, Verdict::kSuspicious);
  EXPECT_EQ(parts[test::kArm].reason, findings[0].text);
  parts[test::kArm].status = Verdict::kNotOk;
  judge_unexpected(jointed().design, {it}, parts);
  EXPECT_EQ(parts[test::kArm].status, Verdict::kNotOk);
}

}  // namespace
}  // namespace spool
