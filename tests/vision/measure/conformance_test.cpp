// Tests of the decision: probabilities against counting, both limits, coarse measurements.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/conformance.h"

#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(Conformance, IsTheNormalProbabilityBetweenTheLimits) {
  EXPECT_NEAR(conformance_of(0, 1, 1.959964).probability, 0.95, 1e-6);
  EXPECT_NEAR(conformance_of(3, 1e-3, 3).probability, 0.5, 1e-9);
  EXPECT_NEAR(conformance_of(-3, 1e-3, 3).probability, 0.5, 1e-9);
  EXPECT_NEAR(conformance_of(2, 1, 3).probability, 0.8413447 - 2.867e-7, 1e-6);
}

TEST(Conformance, OfATiltCountsTheDisc) {
  Eigen::Matrix2d covariance;
  covariance << 0.9, 0.3, 0.3, 0.4;
  const Eigen::Matrix2d root = covariance.llt().matrixL();
  std::mt19937 random{1};
  std::normal_distribution<double> normal(0, 1);
  for (const double x : {0.0, 0.7, 2.0}) {
    const Eigen::Vector2d tilt(x, -0.4);
    int inside = 0;
    constexpr int kTrials = 200000;
    for (int i = 0; i < kTrials; ++i)
      inside += (tilt + root * Eigen::Vector2d(normal(random), normal(random))).norm() <= 1.5;
    // Four standard deviations of a count of 200 000: 0.0045 at most.
    EXPECT_NEAR(conformance_of(tilt, covariance, 1.5).probability,
                static_cast<double>(inside) / kTrials, 0.0045)
        << x;
  }
}

TEST(Conformance, OfATiltWithoutDoubtIsCertain) {
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  EXPECT_NEAR(conformance_of(Eigen::Vector2d(0.9, 0), none, 1).probability, 1, 1e-6);
  EXPECT_NEAR(conformance_of(Eigen::Vector2d(1.1, 0), none, 1).probability, 0, 1e-6);
}

TEST(Decision, GoesByBothLimits) {
  struct Row {
    double deviation, u;
    Verdict expected;
  };
  // Of +-3: 1.645 u inside is proved right, 1.645 u outside wrong.
  const Row rows[] = {{0, 0.5, Verdict::kOk},
                      {2.17, 0.5, Verdict::kOk},
                      {2.19, 0.5, Verdict::kSuspicious},
                      {-2.19, 0.5, Verdict::kSuspicious},
                      {3.81, 0.5, Verdict::kSuspicious},
                      {3.83, 0.5, Verdict::kNotOk},
                      {-3.83, 0.5, Verdict::kNotOk},
                      {0, 1.52, Verdict::kOk},
                      {0, 1.54, Verdict::kSuspicious}};
  for (const Row& row : rows)
    EXPECT_EQ(decide(conformance_of(row.deviation, row.u, 3)), row.expected)
        << row.deviation << " " << row.u;
}

TEST(Decision, AMeasurementFarCoarserThanTheToleranceSaysNothing) {
  EXPECT_LT(conformance_of(10, 100, 3).probability, 0.05);
  EXPECT_EQ(decide(conformance_of(10, 100, 3)), Verdict::kSuspicious);
  const Eigen::Matrix2d coarse = 100 * Eigen::Matrix2d::Identity();
  EXPECT_LT(conformance_of(Eigen::Vector2d(1, 1), coarse, 0.5).probability, 0.05);
  EXPECT_EQ(decide(conformance_of(Eigen::Vector2d(1, 1), coarse, 0.5)), Verdict::kSuspicious);
  EXPECT_EQ(decide(conformance_of(Eigen::Vector2d(37, 0), coarse, 0.5)), Verdict::kSuspicious);
  EXPECT_EQ(decide(conformance_of(Eigen::Vector2d(38, 0), coarse, 0.5)), Verdict::kNotOk);
}

TEST(Decision, OfManyCoarseReadingsOfGoodWorkHardlyAnyIsCalledWrong) {
  // At half the tolerance, read with u as large as it: 1.645 u over it happened to one in 60.
  std::mt19937 random{2};
  std::normal_distribution<double> normal(0, 1);
  constexpr int kTrials = 40000;
  int wrong = 0, tilted = 0;
  for (int i = 0; i < kTrials; ++i) {
    wrong += decide(conformance_of(1.5 + 3 * normal(random), 3, 3)) == Verdict::kNotOk;
    const Eigen::Vector2d tilt(1.5 + 3 * normal(random), 3 * normal(random));
    tilted += i % 10 == 0 &&
              decide(conformance_of(tilt, 9 * Eigen::Matrix2d::Identity(), 3)) == Verdict::kNotOk;
  }
  EXPECT_LT(wrong, kTrials / 500);
  EXPECT_LT(tilted, kTrials / 10 / 500);
}

}  // namespace
}  // namespace spool
