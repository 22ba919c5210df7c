// Tests of the chain of joints: as drawn, one joint wrong, what is not observed, how sure it is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/joint_errors.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

#include <gtest/gtest.h>

#include "tests/vision/measure/three_leg_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCalibrated = 0.0002;

ChainResult measured(const DesignModel& design, const PartFeatures& features) {
  return measure_joints(design, drawing_of(design), features, pfi_es3(), kCalibrated);
}

ChainResult of_legs(const std::vector<Pose>& built, std::uint32_t seed = 1) {
  const DesignModel design = test::three_leg_spool();
  return measured(design, test::features_of_legs(design, built, seed));
}

Pose turned(const Vector3d& point, const Vector3d& axis, double degrees) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector(axis * degrees * kDegree);
  pose.translation() = point - pose.linear() * point;
  return pose;
}

const JointError& find(const ChainResult& chain, const std::string& weld) {
  for (const JointError& joint : chain.joints)
    if (joint.weld == weld) return joint;
  ADD_FAILURE() << "no joint " << weld;
  static const JointError kNone;
  return kNone;
}

std::string blamed(const ChainResult& chain) {
  std::string welds;
  for (const JointError& joint : chain.joints)
    if (joint.is_to_blame) welds += joint.weld;
  return welds;
}

// The motion of all beyond as the error of that joint, whatever of it is observed.
Vector6d truth(const JointError& joint, const Pose& motion) {
  const Pose E = joint.T_design_joint.inverse() * motion * joint.T_design_joint;
  Vector6d error;
  error << E.translation(), rotation_vector(E.linear());
  return error;
}

const Vector3d kCentre1(0, 0, 0.65), kCentre2(0.8, 0, 0.65);

TEST(JointErrors, OfASpoolAsDrawnBlameNothing) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const ChainResult chain =
        of_legs(test::legs_moved_from(test::kLegParts, Pose::Identity()), seed);
    ASSERT_EQ(chain.joints.size(), 4U);
    for (const JointError& joint : chain.joints) {
      EXPECT_TRUE(joint.is_measured) << joint.weld << joint.reason;
      EXPECT_FALSE(joint.is_significant) << joint.weld << " " << joint.error.transpose();
      EXPECT_EQ(joint.blame, 0);
      // Of 0.5 mm of noise: within 1 mm and 0.2 degrees.
      EXPECT_LT(joint.error.head<3>().norm(), 0.001) << joint.weld;
      EXPECT_LT(joint.error.tail<3>().norm(), 0.2 * kDegree) << joint.weld;
    }
  }
}

TEST(JointErrors, SayWhichJointsAreOneAndWhatIsNotObserved) {
  const ChainResult chain = of_legs(test::legs_moved_from(test::kLegParts, Pose::Identity()));
  EXPECT_NE(chain.datum.find("flange_a/face"), std::string::npos) << chain.datum;
  EXPECT_FALSE(chain.is_turn_held);
  // A face does not know its shift and turn in its plane: with what the pipe lacks, it leans only.
  const JointError& datum = find(chain, "W1");
  EXPECT_EQ(datum.unobserved.size(), 3U);
  for (const int k : {0, 1, 5}) EXPECT_EQ(datum.covariance(k, k), 0) << k;
  for (const int k : {3, 4}) EXPECT_GT(datum.covariance(k, k), 0) << k;
  // The first elbow: the pipe beyond neither slides nor turns, and nothing holds the spool's turn.
  const JointError& first = find(chain, "W2+W3");
  EXPECT_EQ(first.joints, (std::vector<int>{1, 2}));
  EXPECT_EQ(first.near_port, "pipe_1/out");
  EXPECT_EQ(first.far_port, "pipe_2/in");
  EXPECT_EQ(first.unobserved.size(), 3U);
  for (const int k : {0, 3, 5}) EXPECT_EQ(first.covariance(k, k), 0) << k;
  for (const int k : {1, 2, 4}) EXPECT_GT(first.covariance(k, k), 0) << k;
  // The second: its turn about pipe_2 is held by the first leg.
  const JointError& second = find(chain, "W4+W5");
  EXPECT_EQ(second.unobserved.size(), 2U);
  EXPECT_GT(second.covariance(5, 5), 0);
  const JointError& face = find(chain, "W6");
  for (const int k : {0, 1, 5}) EXPECT_EQ(face.covariance(k, k), 0) << k;
  for (const int k : {2, 3, 4}) EXPECT_GT(face.covariance(k, k), 0) << k;
  ASSERT_EQ(chain.ends.size(), 2U);
  EXPECT_EQ(chain.ends[1].end, "flange_b/face");
}

struct OneWrong {
  const char* weld;
  int first;  // part that moved, with all beyond
  Pose motion;
  std::vector<int> observed;
};

class OneJointWrong : public testing::TestWithParam<OneWrong> {};

TEST_P(OneJointWrong, IsBlamedWithItsErrorAndItsEffectAtTheFarEnd) {
  const OneWrong& wrong = GetParam();
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const ChainResult chain = of_legs(test::legs_moved_from(wrong.first, wrong.motion), seed);
    EXPECT_EQ(blamed(chain), wrong.weld);
    const JointError& joint = find(chain, wrong.weld);
    EXPECT_GT(joint.blame, 0.5);
    const Vector6d error = truth(joint, wrong.motion);
    for (const int k : wrong.observed)
      EXPECT_NEAR(joint.error[k], error[k], 3.5 * std::sqrt(joint.covariance(k, k))) << k;
    ASSERT_EQ(joint.ends.size(), 1U);
    EXPECT_EQ(joint.ends[0].end, "flange_b/face");
    const Vector3d far(0.8, 0.68, 0.65);
    const Vector3d moved = wrong.motion * far - far;
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(joint.ends[0].displacement_m[k], moved[k],
                  3.5 * std::sqrt(joint.ends[0].displacement_covariance(k, k)) + 2e-4)
          << k;  // 0.2 mm: what an angle of 1 degree shortens 0.68 m by, and more
    // The chain's sum is where the end is.
    Vector3d sum = Vector3d::Zero();
    for (const JointError& each : chain.joints)
      for (const EndEffect& effect : each.ends)
        if (effect.end == "flange_b/face") sum += effect.displacement_m;
    EXPECT_LT((sum - chain.ends[1].displacement_m).norm(), 2e-4);
    EXPECT_GT(joint.ends[0].tilt_rad.norm() + joint.ends[0].displacement_m.norm(), 0.002);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, OneJointWrong,
    testing::Values(
        OneWrong{"W4+W5", test::kElbow2, turned(kCentre2, Vector3d::UnitX(), 1), {1, 2, 4, 5}},
        OneWrong{"W4+W5", test::kElbow2, turned(kCentre2, Vector3d::UnitZ(), 0.9), {1, 2, 4, 5}},
        OneWrong{"W4+W5", test::kElbow2, Pose(Eigen::Translation3d(0.006, 0, 0)), {1, 2, 4, 5}},
        OneWrong{"W4+W5", test::kElbow2, Pose(Eigen::Translation3d(0, 0, -0.005)), {1, 2, 4, 5}},
        OneWrong{"W2+W3", test::kElbow1, turned(kCentre1, Vector3d::UnitY(), 0.6), {1, 2, 4}},
        OneWrong{"W2+W3", test::kElbow1, Pose(Eigen::Translation3d(0, 0, 0.005)), {1, 2, 4}},
        OneWrong{"W6", test::kLegFlangeB, Pose(Eigen::Translation3d(0, 0.006, 0)), {2, 3, 4}},
        OneWrong{
            "W6", test::kLegFlangeB, turned({0.8, 0.65, 0.65}, Vector3d::UnitX(), 1), {2, 3, 4}}));

// Eight holes read on a flange that was moved from its nominal place, then turned in its face.
PartFeature holes_on(const DesignModel& design, int part, const Pose& built, double turn_rad) {
  const Part& flange = design.parts[static_cast<std::size_t>(part)];
  PartFeature holes{.part = part, .kind = FeatureKind::kHoles};
  holes.T_design_nominal =
      Eigen::Translation3d(flange.T_design_part * flange.ports[0].position) *
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(),
                                         flange.T_design_part.linear() * flange.ports[0].direction);
  holes.T_design_measured =
      built * holes.T_design_nominal * Eigen::AngleAxisd(turn_rad, Vector3d::UnitZ());
  holes.is_observed = {false, false, false, false, false, true};
  holes.fit_covariance(5, 5) = std::pow(0.05 * kDegree, 2);
  return holes;
}

struct Holes {
  int part;
  double turn_rad;
};

ChainResult of_holed_legs(const std::vector<Pose>& built, const std::vector<Holes>& holes) {
  DesignModel design = test::three_leg_spool();
  for (const int p : {test::kLegFlangeA, test::kLegFlangeB})
    design.parts[static_cast<std::size_t>(p)].holes = BoltHoles{.count = 8, .bolt_circle_m = 0.19};
  PartFeatures features = test::features_of_legs(design, built, 1);
  for (const Holes& each : holes)
    features.features.push_back(
        holes_on(design, each.part, built[static_cast<std::size_t>(each.part)], each.turn_rad));
  return measured(design, features);
}

TEST(JointErrors, OfARolledFirstElbowAreSeenWhereTheDatumsHolesHoldItsTurn) {
  const std::vector<Pose> built =
      test::legs_moved_from(test::kElbow1, turned(kCentre1, Vector3d::UnitZ(), 0.7));
  EXPECT_EQ(blamed(of_holed_legs(built, {})), "") << "the whole spool may be turned";
  // A pitch further is another hole in the same place.
  for (const double turn : {0.0, 45 * kDegree, -90 * kDegree}) {
    const ChainResult chain = of_holed_legs(built, {{test::kLegFlangeA, turn}});
    EXPECT_TRUE(chain.is_turn_held);
    EXPECT_EQ(blamed(chain), "W2+W3");
    const JointError& elbow = find(chain, "W2+W3");
    EXPECT_NEAR(elbow.error[5], 0.7 * kDegree, 3 * std::sqrt(elbow.covariance(5, 5)));
    EXPECT_GE(elbow.covariance(5, 5), std::pow(0.05 * kDegree, 2));
    EXPECT_EQ(elbow.unobserved.size(), 2U);
    EXPECT_EQ(find(chain, "W1").covariance(5, 5), 0) << "it is what the turn is seen from";
  }
}

TEST(JointErrors, OfAFlangeTurnedInItsFaceAreSeenByItsHoles) {
  const std::vector<Pose> built = test::legs_moved_from(test::kLegParts, Pose::Identity());
  for (const double turn : {2 * kDegree, -2 * kDegree, 47 * kDegree}) {
    const ChainResult chain = of_holed_legs(built, {{test::kLegFlangeB, turn}});
    const JointError& face = find(chain, "W6");
    EXPECT_GE(face.covariance(5, 5), std::pow(0.05 * kDegree, 2));
    EXPECT_NEAR(std::abs(face.error[5]), 2 * kDegree, 3 * std::sqrt(face.covariance(5, 5)));
    EXPECT_EQ(face.error[5] > 0, turn > 0) << "about y, as the joint's z is";
    EXPECT_EQ(face.unobserved.size(), 2U);
    EXPECT_TRUE(face.is_significant);
  }
}

TEST(JointErrors, HoldNothingByHolesThatStandHalfAPitchOff) {
  const std::vector<Pose> built = test::legs_moved_from(test::kLegParts, Pose::Identity());
  const ChainResult chain = of_holed_legs(
      built, {{test::kLegFlangeA, 22.5 * kDegree}, {test::kLegFlangeB, 21 * kDegree}});
  EXPECT_FALSE(chain.is_turn_held);
  EXPECT_EQ(find(chain, "W6").covariance(5, 5), 0);
  EXPECT_EQ(blamed(chain), "");
}

// Errors against truth, over draws of the noise with random small errors at every joint.
TEST(JointErrors, AreWithinTwiceTheirUncertaintyAsOftenAsStated) {
  const DesignModel design = test::three_leg_spool();
  const ChainResult plan = of_legs(test::legs_moved_from(test::kLegParts, Pose::Identity()));
  int inside = 0, all = 0, ends_inside = 0, ends = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random{1000 + seed};
    std::normal_distribution<double> mm(0, 0.001), angle(0, 0.15 * kDegree);
    // Only what is observed: what is not would be counted at the next joint.
    const Pose bend1 = turned(kCentre1, Vector3d::UnitY(), angle(random) / kDegree) *
                       Eigen::Translation3d(0, mm(random), mm(random));
    const Pose bend2 = turned(kCentre2, Vector3d::UnitX(), angle(random) / kDegree) *
                       turned(kCentre2, Vector3d::UnitZ(), angle(random) / kDegree) *
                       Eigen::Translation3d(mm(random), 0, mm(random));
    const Pose longer(Eigen::Translation3d(0, mm(random), 0));
    std::vector<Pose> built(test::kLegParts, Pose::Identity());
    for (const int p : {test::kElbow1, test::kLeg2}) built[static_cast<std::size_t>(p)] = bend1;
    for (const int p : {test::kElbow2, test::kLeg3})
      built[static_cast<std::size_t>(p)] = bend1 * bend2;
    built[test::kLegFlangeB] = bend1 * bend2 * longer;
    const ChainResult chain = measured(design, test::features_of_legs(design, built, seed));
    const std::pair<const char*, Pose> made[] = {
        {"W1", Pose::Identity()}, {"W2+W3", bend1}, {"W4+W5", bend2}, {"W6", longer}};
    for (const auto& [weld, motion] : made) {
      const JointError& joint = find(chain, weld);
      const Vector6d error = truth(joint, motion);
      for (int k = 0; k < 6; ++k) {
        if (!(joint.covariance(k, k) > 0)) continue;
        ++all;
        inside += std::abs(joint.error[k] - error[k]) < 2 * std::sqrt(joint.covariance(k, k));
      }
    }
    const Vector3d far(0.8, 0.68, 0.65);
    const Vector3d off = built[test::kLegFlangeB] * far - far;
    for (int k = 0; k < 3; ++k) {
      ++ends;
      ends_inside += std::abs(chain.ends[1].displacement_m[k] - off[k]) <
                     2 * std::sqrt(chain.ends[1].displacement_covariance(k, k));
    }
  }
  ASSERT_EQ(plan.joints.size(), 4U);
  EXPECT_GE(inside, 0.9 * all) << inside << " of " << all;
  EXPECT_GE(ends_inside, 0.9 * ends) << ends_inside << " of " << ends;
  RecordProperty("inside", inside);
  RecordProperty("all", all);
}

TEST(JointErrors, OfTheTwoFlangeSpoolAreOfOneElbow) {
  const DesignModel design = test::two_flange_spool();
  test::SpoolScan scan;
  const Pose out = turned({0, 0, 0.65}, Vector3d::UnitY(), -1);
  scan.T_design_built[test::kPipe2] = scan.T_design_built[test::kFlangeB] = out;
  const ChainResult chain = measured(design, test::features_of(design, scan));
  EXPECT_EQ(chain.joints.size(), 3U);
  // The datum is the flange that is known best: seen from either, the elbow is it.
  const std::string weld = blamed(chain);
  EXPECT_TRUE(weld == "W2+W3" || weld == "W3+W2") << weld;
  for (const JointError& joint : chain.joints)
    if (joint.is_to_blame) {
      EXPECT_NEAR(joint.error.tail<3>().norm(), kDegree, 0.1 * kDegree);
    }
}

TEST(JointErrors, WhatWasNotSeenIsNotMeasuredWithTheReason) {
  const DesignModel design = test::two_flange_spool();
  test::SpoolScan scan;
  scan.is_there[test::kFlangeB] = false;
  const ChainResult without_face = measured(design, test::features_of(design, scan));
  EXPECT_TRUE(find(without_face, "W2+W3").is_measured);
  EXPECT_FALSE(find(without_face, "W4").is_measured);
  EXPECT_NE(find(without_face, "W4").reason.find("flange_b"), std::string::npos);
  scan = {};
  scan.is_there[test::kPipe2] = false;
  const ChainResult without_pipe = measured(design, test::features_of(design, scan));
  // The face beyond still leans against pipe_1, over three joints together.
  EXPECT_EQ(find(without_pipe, "W2+W3+W4").part_far, test::kFlangeB);
  EXPECT_EQ(blamed(without_pipe), "");
  scan.is_there.assign(test::kSpoolParts, false);
  scan.is_there[test::kFlangeA] = true;
  const ChainResult nothing = measured(design, test::features_of(design, scan));
  ASSERT_EQ(nothing.joints.size(), 4U);
  for (const JointError& joint : nothing.joints) {
    EXPECT_FALSE(joint.is_measured);
    EXPECT_FALSE(joint.reason.empty());
  }
}

TEST(JointErrors, OfACancelledRunAreNone) {
  const DesignModel design = test::three_leg_spool();
  const PartFeatures features =
      test::features_of_legs(design, test::legs_moved_from(test::kLegParts, Pose::Identity()), 1);
  std::stop_source cancel;
  cancel.request_stop();
  const ChainResult chain =
      measure_joints(design, drawing_of(design), features, pfi_es3(), kCalibrated,
                     {.stop = cancel.get_token(), .progress = {}});
  EXPECT_TRUE(chain.joints.empty());
  EXPECT_TRUE(chain.ends.empty());
}

TEST(JointErrors, OfADesignWithoutJointsOrWithPartsApartAreNone) {
  DesignModel design = test::two_flange_spool();
  const PartFeatures features = test::features_of(design, test::SpoolScan{});
  design.joints.clear();
  EXPECT_TRUE(measured(design, features).joints.empty());
  design = test::two_flange_spool();
  design.joints.erase(design.joints.begin() + 1);  // pipe_1 and elbow_1 do not meet
  const ChainResult apart = measured(design, features);
  EXPECT_EQ(blamed(apart), "");
  int told = 0;
  for (const JointError& joint : apart.joints) told += joint.is_measured || !joint.reason.empty();
  EXPECT_EQ(told, 3);
}

}  // namespace
}  // namespace spool
