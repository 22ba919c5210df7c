// Tests of the regression: exact data, laws, its intervals against trials, what it cannot
// determine.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/regression.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

Eigen::MatrixXd random_inputs(Eigen::Index rows, std::mt19937& random) {
  std::normal_distribution<double> gauss(0, 1);
  Eigen::MatrixXd inputs(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i) inputs.row(i) << gauss(random), 5 + 2 * gauss(random);
  return inputs;
}

TEST(Regression, FindsThePlaneThatDataLieOn) {
  std::mt19937 random{1};
  const Eigen::MatrixXd inputs = random_inputs(9, random);
  const Eigen::VectorXd y = 3 + 2 * inputs.col(0).array() - 0.5 * inputs.col(1).array();
  const Regression fit = regress(inputs, y);
  ASSERT_TRUE(fit.is_determined);
  EXPECT_TRUE(fit.coefficients.isApprox(Eigen::Vector3d(3, 2, -0.5), 1e-12));
  EXPECT_NEAR(fit.r_squared, 1, 1e-12);
  EXPECT_NEAR(fit.left_out_r_squared, 1, 1e-12);
  EXPECT_LT(fit.p, 1e-9);
  EXPECT_NEAR(fit.predict(Eigen::Vector2d(1, 2)), 4, 1e-12);
}

TEST(Regression, AgreesWithTheLineByHand) {
  // x 1 2 3 4, y 1 3 2 5: slope 5.5 / 5, SST 8.75, SSR 6.05; residual variance 2.7 / 2.
  const Regression fit =
      regress(Eigen::Vector4d(1, 2, 3, 4), Eigen::VectorXd(Eigen::Vector4d(1, 3, 2, 5)));
  EXPECT_NEAR(fit.coefficients[1], 1.1, 1e-12);
  EXPECT_NEAR(fit.coefficients[0], 0, 1e-12);
  EXPECT_NEAR(fit.sum_of_squares, 8.75, 1e-12);
  EXPECT_NEAR(fit.residual_squares, 2.7, 1e-12);
  EXPECT_NEAR(fit.r_squared, 6.05 / 8.75, 1e-12);
  EXPECT_NEAR(fit.adjusted_r_squared, 1 - 1.35 / (8.75 / 3), 1e-12);
  EXPECT_NEAR(fit.f, 6.05 / 1.35, 1e-12);
  // 4.3027 is Student's limit on 2 degrees; the slope's standard error sqrt(1.35 / 5).
  EXPECT_NEAR(fit.high[1] - 1.1, 4.3027 * std::sqrt(0.27), 1e-4);
  EXPECT_NEAR(1.1 - fit.low[1], 4.3027 * std::sqrt(0.27), 1e-4);
}

TEST(Regression, LeavingOutIsLeavingOut) {
  std::mt19937 random{2};
  std::normal_distribution<double> gauss(0, 1);
  const Eigen::MatrixXd inputs = random_inputs(8, random);
  Eigen::VectorXd y(8);
  for (auto& value : y) value = gauss(random);
  const Regression all = regress(inputs, y);
  double press = 0;
  for (Eigen::Index out = 0; out < 8; ++out) {
    Eigen::MatrixXd some(7, 2);
    Eigen::VectorXd some_y(7);
    for (Eigen::Index i = 0, to = 0; i < 8; ++i) {
      if (i == out) continue;
      some.row(to) = inputs.row(i);
      some_y[to++] = y[i];
    }
    const Eigen::VectorXd inputs_out = inputs.row(out).transpose();
    press += std::pow(y[out] - regress(some, some_y).predict(inputs_out), 2);
  }
  EXPECT_NEAR(all.left_out_r_squared, 1 - press / all.sum_of_squares, 1e-9);
}

TEST(Regression, ItsIntervalsHoldTheTruthNineteenTimesInTwenty) {
  std::mt19937 random{3};
  std::normal_distribution<double> gauss(0, 1);
  constexpr int kTrials = 2000;
  Eigen::Vector3i held = Eigen::Vector3i::Zero();
  int chance = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::MatrixXd inputs = random_inputs(7, random);
    Eigen::VectorXd noise(7);
    for (auto& value : noise) value = gauss(random);
    const Regression fit = regress(inputs, 1 + 2 * inputs.col(0).array() + noise.array());
    for (Eigen::Index i = 0; i < 3; ++i)
      held[i] += fit.low[i] <= (i == 0   ? 1
                                : i == 1 ? 2
                                         : 0) &&
                         fit.high[i] >= (i == 0   ? 1
                                         : i == 1 ? 2
                                                  : 0)
                     ? 1
                     : 0;
    chance += regress(inputs, noise).p < 0.05 ? 1 : 0;
  }
  // 95 % of 2000 with a standard deviation of 0.5 %: four of them.
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(held[i] / double(kTrials), 0.95, 0.02);
  EXPECT_NEAR(chance / double(kTrials), 0.05, 0.02);
}

TEST(Regression, WhatDoesNotDetermineAPlaneIsSaid) {
  const Eigen::Vector4d y(1, 2, 3, 5);
  Eigen::MatrixXd inputs(4, 2);
  inputs << 1, 2, 2, 4, 3, 6, 4, 8;
  EXPECT_FALSE(regress(inputs, y).is_determined) << "one input is twice the other";
  inputs.col(1).setConstant(7);
  EXPECT_FALSE(regress(inputs, y).is_determined) << "an input that is constant";
  inputs.col(1) << 1, 0, 0, NAN;
  EXPECT_FALSE(regress(inputs, y).is_determined);
  EXPECT_FALSE(regress(Eigen::MatrixXd::Random(3, 2), Eigen::Vector3d(1, 2, 3)).is_determined)
      << "no observation is left to doubt three coefficients";
  const Regression flat = regress(Eigen::Vector4d(1, 2, 3, 4), Eigen::VectorXd::Constant(4, 6));
  EXPECT_TRUE(flat.is_determined);
  EXPECT_NEAR(flat.coefficients[0], 6, 1e-12);
  EXPECT_EQ(flat.r_squared, 0);
}

}  // namespace
}  // namespace spool
