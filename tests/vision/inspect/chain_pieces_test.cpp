// Pieces turned, too long or exchanged are found where they are, and nothing else is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/chain_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"
#include "vision/inspect/datum_side.h"
#include "vision/inspect/missing_parts.h"
#include "vision/inspect/piece_shape.h"
#include "vision/inspect/spool_findings.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::jointed;
using test::JointedSpool;
using test::kArm;
using test::kEnd;
using test::kFoot;
using test::kRiser;
using test::kSide;
using test::kTip;

constexpr double kNoise = 0.001;  // m
const std::vector<bool> kAll(6, true);

Explanation explain(const PointCloud& scan) {
  const ExplainedScan explained{scan, kNoise, true};
  Explanation explanation = explain_surface(jointed().explained(), explained);
  explain_pieces(jointed().explained(), explained, {}, explanation);
  return explanation;
}

// How far (m) `a` puts the part's middle from where `b` puts it, at most over its length.
double apart(const Pose& a, const Pose& b, int part) {
  const test::Rod& rod = jointed().rods[static_cast<std::size_t>(part)];
  double worst = 0;
  for (const double along : {0.0, 0.5, 1.0}) {
    const Vector3d p = rod.base + along * rod.length * rod.direction;
    worst = std::max(worst, (a * p - b * p).norm());
  }
  return worst;
}

TEST(ChainPieces, AreNoneOfASpoolBuiltAsDesigned) {
  const PointCloud scan = jointed().scan(jointed().as_designed(), kAll);
  const Explanation explanation = explain(scan);
  EXPECT_TRUE(explanation.pieces.empty());
  EXPECT_EQ(explanation.declutter.contradicting, 0U);
}

// What is elsewhere vouches for no part, neither its own nor what it lies near.
TEST(ChainPieces, VouchForNoPart) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::turned_about({0.63, 0, 0.8}, Vector3d::UnitX(), 90);
  const PointCloud scan = jointed().scan(built, kAll);
  const Explanation explanation = explain(scan);
  ASSERT_EQ(explanation.pieces.size(), 1U);
  const auto parts = summarise_parts(jointed().design, scan, explanation.declutter.classes,
                                     explanation.deviations, jointed().samples);
  EXPECT_LT(parts[kTip].coverage, 0.2);
  EXPECT_GT(parts[kArm].coverage, 0.8);
}

// What of it lies within 20 mm of another part is not that part with a deviation.
TEST(ChainPieces, KeepTheirPointsFromTheirNeighbours) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::turned_about({0.6, 0, 0.8}, Vector3d::UnitX(), 15);
  const PointCloud scan = jointed().scan(built, kAll);
  const Explanation explanation = explain(scan);
  ASSERT_EQ(explanation.pieces.size(), 1U);
  std::size_t off = 0;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (explanation.declutter.classes[i] == PointClass::kObject)
      off += std::abs(explanation.deviations.distance_m[i]) > 5 * kNoise ? 1U : 0U;
  EXPECT_LT(off, 10U);
}

class TurnedTip : public testing::TestWithParam<double> {};

TEST_P(TurnedTip, IsFoundAtItsJoint) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::turned_about({0.6, 0, 0.8}, Vector3d::UnitX(), GetParam());
  const PointCloud scan = jointed().scan(built, kAll);
  const Explanation explanation = explain(scan);
  ASSERT_EQ(explanation.pieces.size(), 1U);
  const Piece& piece = explanation.pieces[0];
  EXPECT_EQ(piece.part, kTip);
  EXPECT_EQ(piece.parts, std::vector<int>{kTip});
  EXPECT_EQ(piece.fault, PieceFault::kTurned);
  EXPECT_NEAR(piece.amount, std::abs(GetParam()) * std::numbers::pi / 180, 0.01);
  EXPECT_LT(apart(piece.motion, built[kTip], kTip), 0.003);
  // Every point of it is kept, as contradicting.
  EXPECT_GT(explanation.declutter.contradicting, 600U);
  EXPECT_LT(explanation.declutter.clutter, scan.size() / 100);
}

INSTANTIATE_TEST_SUITE_P(Degrees, TurnedTip, testing::Values(30.0, 90.0, -90.0, 145.0, 180.0));

TEST(ChainPieces, TellAPipeThatIsTooLongAndKeepItsExcess) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::moved({0.08, 0, 0});
  PointCloud scan = jointed().scan(built, kAll);
  // The arm goes on for 80 mm.
  std::mt19937 random{7};
  const test::Rod excess{{0.63, 0, 0.8}, Vector3d::UnitX(), 0.03, 0.08};
  const PointCloud more = test::scan_of(
      {excess}, Pose::Identity(), {.points = 200, .noise_m = kNoise, .with_ends = false}, random);
  scan.points.insert(scan.points.end(), more.points.begin(), more.points.end());
  scan.normals.insert(scan.normals.end(), more.normals.begin(), more.normals.end());
  const Explanation explanation = explain(scan);
  ASSERT_EQ(explanation.pieces.size(), 1U);
  EXPECT_EQ(explanation.pieces[0].fault, PieceFault::kTooLong);
  EXPECT_EQ(explanation.pieces[0].part, kArm);
  EXPECT_NEAR(explanation.pieces[0].amount, 0.08, 0.003);
  const auto& classes = explanation.declutter.classes;
  const auto kept_excess =
      std::count(classes.end() - 200, classes.end(), PointClass::kContradicting) +
      std::count(classes.end() - 200, classes.end(), PointClass::kObject);
  EXPECT_GT(kept_excess, 190);
}

TEST(ChainPieces, NameBothBranchesThatChangedPlaces) {
  // The arm with its tip hangs where the side branch belongs, and the other way round.
  const JointFrame arm{{0, 0, 0.8F}, Eigen::Vector3f::UnitZ()};
  const JointFrame side{{0, -0.03F, 0.4F}, -Eigen::Vector3f::UnitY()};
  std::vector<Pose> built = jointed().as_designed();
  built[kArm] = built[kTip] = hung_at(arm, side)[5].cast<double>();
  built[kSide] = built[kEnd] = hung_at(side, arm)[9].cast<double>();
  const Explanation explanation = explain(jointed().scan(built, kAll));
  ASSERT_EQ(explanation.pieces.size(), 2U);
  std::vector<int> named;
  for (const Piece& piece : explanation.pieces) {
    EXPECT_EQ(piece.fault, PieceFault::kExchanged);
    EXPECT_LT(apart(piece.motion, built[static_cast<std::size_t>(piece.part)], piece.part), 0.004);
    named.push_back(piece.part);
  }
  std::sort(named.begin(), named.end());
  EXPECT_EQ(named, (std::vector<int>{kArm, kSide}));
}

// The foot is a plain pipe, as the first length of the side branch is: of that length, which most
// of the branch is, the design explains what lies in either place.
TEST(ChainPieces, NameABranchWhoseFirstLengthLiesOnTheOther) {
  const JointFrame foot{{0, 0.03F, 0.1F}, Eigen::Vector3f::UnitY()};
  const JointFrame side{{0, -0.03F, 0.4F}, -Eigen::Vector3f::UnitY()};
  std::vector<Pose> built = jointed().as_designed();
  built[kFoot] = hung_at(foot, side)[0].cast<double>();
  built[kSide] = built[kEnd] = hung_at(side, foot)[4].cast<double>();
  const Explanation explanation = explain(jointed().scan(built, kAll));
  ASSERT_EQ(explanation.pieces.size(), 1U);
  EXPECT_EQ(explanation.pieces[0].part, kSide);
  EXPECT_EQ(explanation.pieces[0].fault, PieceFault::kExchanged);
  EXPECT_LT(apart(explanation.pieces[0].motion, built[kEnd], kEnd), 0.004);
}

// The tip is missing, and what lies further out looks like it: nothing joins it to the arm.
TEST(ChainPieces, AreNotTooFarOutWithNothingBetween) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::moved({0.13, 0, 0});
  const Explanation explanation = explain(jointed().scan(built, kAll));
  for (const Piece& piece : explanation.pieces) EXPECT_NE(piece.fault, PieceFault::kTooLong);
}

TEST(ChainPieces, AreNotMadeOfClutter) {
  PointCloud scan = jointed().scan(jointed().as_designed(), {true, true, true, false, true, true});
  std::mt19937 random{3};
  std::uniform_real_distribution<float> in(-0.5F, 0.5F);
  for (int i = 0; i < 4000; ++i) {
    scan.points.emplace_back(0.6F + in(random), in(random), 0.8F + in(random));
    scan.normals.emplace_back(Eigen::Vector3f::UnitX());
  }
  EXPECT_TRUE(explain(scan).pieces.empty());
}

TEST(ChainPieces, AreNotMadeOfASquarePostThatStandsWhereOneCouldHang) {
  // The tip was not scanned, and a post as wide as it is stands under the arm's end.
  PointCloud scan = jointed().scan(jointed().as_designed(), {true, true, true, false, true, true});
  std::mt19937 random{5};
  std::uniform_real_distribution<float> across(-0.03F, 0.03F), up(0, 0.77F);
  std::normal_distribution<float> noise(0, static_cast<float>(kNoise));
  for (int i = 0; i < 2400; ++i) {
    const float side = i % 2 == 0 ? 1 : -1, off = side * 0.03F + noise(random), to = across(random);
    const bool is_x = i % 4 < 2;
    scan.points.emplace_back(0.6F + (is_x ? off : to), is_x ? to : off, up(random));
    scan.normals.emplace_back(side * (is_x ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY()));
  }
  EXPECT_TRUE(explain(scan).pieces.empty());
}

TEST(JointTree, SeesTheDatumFromBeyondEachJoint) {
  const auto tree = joint_tree(jointed().design);
  ASSERT_EQ(tree.size(), 5U);
  const auto sides = datum_sides(jointed().design);
  // One a joint, and two for each two of the riser's three joints.
  ASSERT_EQ(sides.size(), 5U + 6U);
  for (std::size_t b = 0; b < tree.size(); ++b) {
    EXPECT_TRUE(sides[b].holds(kRiser));
    EXPECT_EQ(sides[b].parts.size() + tree[b].parts.size(), 6U);
    for (const int part : tree[b].parts) EXPECT_FALSE(sides[b].holds(part));
    EXPECT_EQ(sides[b].frame.outward, -tree[b].frame.outward);
  }
  for (std::size_t b = 5; b < sides.size(); ++b) {
    EXPECT_TRUE(sides[b].holds(kRiser));
    EXPECT_FALSE(sides[b].turns);
    EXPECT_EQ(sides[b].others.size(), 1U);
  }
}

// The scan as the finder gives it: the piece beyond the wrong joint lies as designed, the datum's
// side does not.
class FromBeyond : public testing::TestWithParam<std::pair<const char*, Pose>> {};

TEST_P(FromBeyond, TheDatumsSideIsFound) {
  const Pose wrong = GetParam().second;  // of arm and tip, as seen from the datum
  std::vector<Pose> built(6, wrong.inverse());
  built[kArm] = built[kTip] = Pose::Identity();
  PointCloud scan = jointed().scan(built, kAll);
  if (const auto by = wrong.translation().z(); by > 0) {
    // The riser goes on as far.
    std::mt19937 random{9};
    const PointCloud more =
        test::scan_of({{{0, 0, 0.8 - by}, Vector3d::UnitZ(), 0.03, by}}, Pose::Identity(),
                      {.points = 200, .noise_m = kNoise, .with_ends = false}, random);
    scan.points.insert(scan.points.end(), more.points.begin(), more.points.end());
    scan.normals.insert(scan.normals.end(), more.normals.begin(), more.normals.end());
  }
  const ExplainedScan explained{scan, kNoise, true};
  const Explanation explanation = explain_surface(jointed().explained(), explained);
  const auto side = datum_side(jointed().explained(), explained, explanation);
  ASSERT_TRUE(side);
  for (const int part : {kRiser, kFoot, kSide, kEnd}) {
    EXPECT_EQ(side->is_held[static_cast<std::size_t>(part)], 1);
    EXPECT_LT(apart(side->T_new_old, wrong, part), 0.004);
  }
  EXPECT_EQ(side->is_held[kTip], 0);
}

INSTANTIATE_TEST_SUITE_P(
    Joints, FromBeyond,
    testing::Values(std::pair("turned", test::turned_about({0, 0, 0}, Vector3d::UnitZ(), 90)),
                    std::pair("turned_a_little",
                              test::turned_about({0, 0, 0}, Vector3d::UnitZ(), -25)),
                    std::pair("too_long", test::moved({0, 0, 0.09}))),
    [](const auto& row) { return std::string(row.param.first); });

TEST(DatumSide, IsNoneWhereAllIsAsDesigned) {
  const PointCloud scan = jointed().scan(jointed().as_designed(), kAll);
  const ExplainedScan explained{scan, kNoise, true};
  const Explanation explanation = explain_surface(jointed().explained(), explained);
  EXPECT_FALSE(datum_side(jointed().explained(), explained, explanation));
}

TEST(DatumSide, IsNoneWhereAnotherPartIsWrong) {
  std::vector<Pose> built = jointed().as_designed();
  built[kTip] = test::turned_about({0.6, 0, 0.8}, Vector3d::UnitX(), 90);
  const PointCloud scan = jointed().scan(built, kAll);
  const ExplainedScan explained{scan, kNoise, true};
  const Explanation explanation = explain_surface(jointed().explained(), explained);
  EXPECT_FALSE(datum_side(jointed().explained(), explained, explanation));
}

TEST(DatumSide, APoseOfAPieceIsNoDoubt) {
  Piece piece;
  piece.parts = {kTip};
  piece.motion = test::turned_about({0.6, 0, 0.8}, Vector3d::UnitX(), 90);
  const Pose T_found = test::turned_about({1, 2, 3}, Vector3d(1, 1, 0), 50);
  // The pose that has the tip in place.
  const Pose T_other = piece.motion.inverse() * T_found;
  EXPECT_TRUE(is_of_a_piece(T_other, T_found, {piece}, jointed().explained()));
  EXPECT_FALSE(is_of_a_piece(T_found, T_found, {piece}, jointed().explained()));
  EXPECT_FALSE(is_of_a_piece(T_other, T_found, {}, jointed().explained()));
}

TEST(PieceShape, LeavesToTheJointWhatThePieceDoesNotHold) {
  std::vector<std::uint8_t> riser(6, 0), both(6, 0);
  riser[kRiser] = both[kRiser] = both[kFoot] = 1;
  const Pose turn = test::turned_about({0, 0, 0}, Vector3d::UnitZ(), 1.0);
  const Pose lean = test::turned_about({0, 0, 0.4}, Vector3d::UnitX(), 1.0);
  const PieceShape alone(riser, jointed().samples), footed(both, jointed().samples);
  EXPECT_LT(pose_size(alone.as_held(turn)).rotation_rad, 1e-4);
  EXPECT_NEAR(pose_size(alone.as_held(lean)).rotation_rad, std::numbers::pi / 180, 1e-4);
  EXPECT_NEAR(pose_size(footed.as_held(turn)).rotation_rad, std::numbers::pi / 180, 1e-4);
  // What hangs elsewhere has no joint to ask: whatever its surface holds counts, and no more.
  std::vector<std::uint8_t> stub(riser);
  stub[kFoot] = 1;
  SurfaceSamples little = jointed().samples;
  for (std::size_t s = 0, kept = 0; s < little.part.size(); ++s)
    if (little.part[s] == kFoot && (little.cloud.points[s].y() > 0.06F || ++kept > 25))
      little.part[s] = kTip;
  const PieceShape weak(stub, little);
  EXPECT_LT(pose_size(weak.as_held(turn)).rotation_rad, 1e-4);
  EXPECT_NEAR(pose_size(weak.as_held(turn, HeldBy::kShape)).rotation_rad, std::numbers::pi / 180,
              1e-4);
  EXPECT_LT(pose_size(alone.as_held(turn, HeldBy::kShape)).rotation_rad, 1e-4);
}

TEST(SpoolFindings, APartOfAPieceElsewhereIsNotMissing) {
  Piece piece;
  piece.joint = 2;
  piece.part = kTip;
  piece.parts = {kTip};
  piece.fault = PieceFault::kTurned;
  piece.amount = std::numbers::pi / 2;
  const std::vector<PartFinding> parts(6);
  const auto findings = spool_findings(jointed().design, {piece}, {}, {{kTip}, {kEnd}}, parts);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].kind, "misplaced");
  EXPECT_EQ(findings[0].text, "tip is turned by 90 degrees at W3 between arm and tip.");
  EXPECT_EQ(findings[1].kind, "missing");
  EXPECT_EQ(findings[1].part, "end");
}

}  // namespace
}  // namespace spool
