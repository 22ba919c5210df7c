// Picked pairs: the pose they give, what noise does to it, and every refusal with its sentence.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/three_point.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;

const std::vector<Vector3d> kPicks = {{0, 0, 0}, {0.8, 0, 0}, {0.1, 0.5, 0}, {0.2, 0.1, 0.4}};

std::vector<PointPair> pairs_at(const Pose& T_design_scan, std::size_t count) {
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < count; ++i)
    pairs.push_back({kPicks[i], T_design_scan.inverse() * kPicks[i]});
  return pairs;
}

TEST(AlignPairs, ReturnsTheExactPoseOfExactPicks) {
  std::mt19937 random{1};
  for (const std::size_t count : {3U, 4U}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Pose T = test::random_motion(2.0, 3.1, random);
      const PairsAlignment found = align_pairs(pairs_at(T, count));
      ASSERT_EQ(found.status, PairsStatus::kOk) << found.reason;
      EXPECT_TRUE(found.T_design_scan.isApprox(T, 1e-12));
      EXPECT_LT(found.rms_m, 1e-12);
      EXPECT_NEAR(found.T_design_scan.linear().determinant(), 1.0, 1e-12);
    }
  }
}

TEST(AlignPairs, NeverScales) {
  auto pairs = pairs_at(Pose::Identity(), 4);
  for (PointPair& pair : pairs) pair.scan *= 1.02;  // 2 %: 8 mm on the longest pick
  const PairsAlignment found = align_pairs(pairs);
  ASSERT_EQ(found.status, PairsStatus::kOk);
  EXPECT_NEAR(found.T_design_scan.linear().determinant(), 1.0, 1e-12);
  EXPECT_GT(found.rms_m, 0.003);  // the scale stays in the residuals, where it shows
}

TEST(AlignPairs, ErrorOfNoisyPicksIsWhatTheLeverArmsPredict) {
  std::mt19937 random{2};
  std::normal_distribution<double> tap(0, 0.005);
  const Vector3d far(0.8, 0.5, 0.4);
  const auto clean = pairs_at(Pose::Identity(), 3);
  double sum = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    auto pairs = clean;
    for (PointPair& pair : pairs) pair.scan += Vector3d(tap(random), tap(random), tap(random));
    const PairsAlignment found = align_pairs(pairs);
    ASSERT_EQ(found.status, PairsStatus::kOk) << found.reason;
    sum += (found.T_design_scan * far - far).squaredNorm();
  }
  // The RMS of 2000 trials is itself known to 2 %; linearising 5 mm over 0.5 m adds under 1 %.
  EXPECT_NEAR(std::sqrt(sum / kTrials) / predicted_error(clean, 0.005, far), 1.0, 0.06);
}

TEST(AlignPairs, RefusesTooFewPairs) {
  const auto two = pairs_at(Pose::Identity(), 2);
  const PairsAlignment found = align_pairs(two);
  EXPECT_EQ(found.status, PairsStatus::kTooFew);
  EXPECT_EQ(found.reason, "Three pairs are needed to place the design and there are 2; pick more.");
  EXPECT_EQ(align_pairs({}).status, PairsStatus::kTooFew);
}

TEST(AlignPairs, RefusesTwoPicksAtOnePlaceAndNamesThem) {
  auto pairs = pairs_at(Pose::Identity(), 4);
  pairs[3].scan = pairs[1].scan + Vector3d(0.004, 0, 0);
  const PairsAlignment found = align_pairs(pairs);
  EXPECT_EQ(found.status, PairsStatus::kCoincident);
  EXPECT_EQ(
      found.reason,
      "Picks 2 and 4 on the scan are at one place (4 mm apart); pick places at least 20 mm from "
      "each other.");
}

TEST(AlignPairs, RefusesPicksOnOneLine) {
  std::vector<PointPair> pairs;
  for (const double x : {0.0, 0.4, 1.0}) pairs.push_back({{x, 0.004 * x * x, 0}, {x, 0, 0.01 * x}});
  const PairsAlignment found = align_pairs(pairs);
  EXPECT_EQ(found.status, PairsStatus::kCollinear);
  EXPECT_NE(found.reason.find("nearly on one line"), std::string::npos) << found.reason;
}

TEST(AlignPairs, RefusesMirroredPicks) {
  auto pairs = pairs_at(Pose::Identity(), 4);
  for (PointPair& pair : pairs) pair.scan.y() *= -1;
  const PairsAlignment found = align_pairs(pairs);
  EXPECT_EQ(found.status, PairsStatus::kMirrored);
  EXPECT_NE(found.reason.find("mirror image"), std::string::npos) << found.reason;
}

TEST(AlignPairs, SaysWhichPicksLookExchanged) {
  std::mt19937 random{3};
  std::normal_distribution<double> tap(0, 0.004);
  for (const std::size_t count : {3U, 4U}) {
    auto pairs = pairs_at(test::random_motion(1, 1, random), count);
    for (PointPair& pair : pairs) pair.scan += Vector3d(tap(random), tap(random), tap(random));
    std::swap(pairs[0].scan, pairs[1].scan);
    const PairsAlignment found = align_pairs(pairs);
    EXPECT_EQ(found.status, PairsStatus::kMirrored);
    EXPECT_EQ(found.reason.substr(0, 36), "Picks 1 and 2 look exchanged between") << found.reason;
  }
}

TEST(AlignPairs, RefusesDistancesThatDoNotFitAndNamesTheWorstPair) {
  auto pairs = pairs_at(Pose::Identity(), 4);
  pairs[2].scan += Vector3d(0, 0.3, 0);
  const PairsAlignment found = align_pairs(pairs);
  EXPECT_EQ(found.status, PairsStatus::kInconsistent);
  EXPECT_NE(found.reason.find("pair 3 is off by"), std::string::npos) << found.reason;
  EXPECT_NE(found.reason.find("(allowed 50 mm)"), std::string::npos) << found.reason;
}

TEST(AlignPairs, RefusesNumbersThatAreNone) {
  auto pairs = pairs_at(Pose::Identity(), 3);
  pairs[1].design.x() = std::nan("");
  EXPECT_EQ(align_pairs(pairs).reason,
            "Pair 2 has a coordinate that is not a number; pick it again.");
}

TEST(AlignPairs, HonestTapsOnASmallObjectAreNotCalledExchanged) {
  // A 10 mm tap on picks 120 mm apart fits badly; it must still not be refused in more than a few
  // cases.
  std::mt19937 random{4};
  int refused = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<PointPair> pairs = {{{0, 0, 0}, {}}, {{0.12, 0, 0}, {}}, {{0.02, 0.09, 0}, {}}};
    for (PointPair& pair : pairs) pair.scan = test::random_motion(0.010, 0, random) * pair.design;
    refused += align_pairs(pairs).status == PairsStatus::kOk ? 0 : 1;
  }
  EXPECT_LE(refused, 5);
}

TEST(AlignPairs, OptionsAreChecked) {
  EXPECT_FALSE(validate(PairsOptions{}));
  EXPECT_TRUE(validate(PairsOptions{.max_residual_m = 0}));
  EXPECT_TRUE(validate(PairsOptions{.min_spread_ratio = std::nan("")}));
}

}  // namespace
}  // namespace spool
