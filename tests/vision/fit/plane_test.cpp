// Tests of the plane fit: truth, its own uncertainty against many trials, clutter.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/plane.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Pose tilted() {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector({0.4, -0.7, 0.2});
  pose.translation() = Eigen::Vector3d(0.3, -1.1, 2.0);
  return pose;
}

// A flange face's worth of points, 0.2 m by 0.1 m, noisy across the plane.
Points noisy_face(std::mt19937& random, int count, double noise_m) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  std::normal_distribution<double> noise(0, 1);
  Points points;
  for (int i = 0; i < count; ++i)
    points.emplace_back((tilted() * Eigen::Vector3d(0.2 * unit(random), 0.1 * unit(random),
                                                    noise_m * noise(random)))
                            .cast<float>());
  return points;
}

double angle_to(const PlaneFit& fit, const Eigen::Vector3d& normal) {
  return std::asin(std::min(1.0, fit.normal().cross(normal).norm()));
}

TEST(PlaneFit, GoesThroughPointsWithoutNoise) {
  std::mt19937 random{1};
  const PlaneFit fit = fit_plane(noisy_face(random, 500, 0));
  ASSERT_TRUE(fit.is_determined);
  EXPECT_LT(angle_to(fit, tilted().linear().col(2)), 2e-6);  // floats near 2 m: 1.2e-7 over 0.1 m
  EXPECT_LT(fit.rms_m, 2e-7);
  EXPECT_NEAR(fit.distance(tilted() * Eigen::Vector3d(0.05, 0.02, 0.01)) *
                  fit.normal().dot(tilted().linear().col(2)),
              0.01, 1e-6);
  EXPECT_NEAR(fit.T_points_plane.linear().determinant(), 1.0, 1e-12);
}

TEST(PlaneFit, KnowsItsOwnUncertainty) {
  std::mt19937 random{2};
  constexpr int kTrials = 600;
  const Eigen::Vector3d truth = tilted().linear().col(2);
  // Squared errors over the variances that the fit gave: each is a chi square of one degree of
  // freedom.
  Eigen::Vector3d ratio = Eigen::Vector3d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    const PlaneFit fit = fit_plane(noisy_face(random, 100, 0.001));
    ASSERT_TRUE(fit.is_determined);
    const Eigen::Vector3d in_plane = fit.T_points_plane.linear().transpose() * truth;
    const double sign = in_plane.z() < 0 ? -1 : 1;
    const double shift = truth.dot(fit.centre() - tilted().translation());
    const Eigen::Vector3d error(shift, -sign * in_plane.y(), sign * in_plane.x());
    ratio += error.cwiseAbs2().cwiseQuotient(fit.error.covariance.diagonal());
  }
  // The mean of 600 chi squares of one: 1 within 4 sqrt(2 / 600) = 0.23.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(ratio[i] / kTrials, 1.0, 0.23) << i;
}

TEST(PlaneFit, TakesTheLargerOfKnownNoiseAndResiduals) {
  std::mt19937 random{3};
  const Points points = noisy_face(random, 400, 0.001);
  EXPECT_NEAR(fit_plane(points).sigma_m, 0.001, 0.00015);  // 4 / sqrt(2 * 400)
  EXPECT_DOUBLE_EQ(fit_plane(points, 0.005).sigma_m, 0.005);
  EXPECT_DOUBLE_EQ(fit_plane(Points(points.begin(), points.begin() + 3), 0.002).sigma_m, 0.002);
}

TEST(PlaneFit, SaysWhenThereIsNoPlane) {
  EXPECT_FALSE(fit_plane(Points{}).is_determined);
  EXPECT_FALSE(fit_plane(Points{{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}}).is_determined);
  EXPECT_FALSE(fit_plane(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).is_determined);
  EXPECT_FALSE(fit_plane(Points(50, {1, 2, 3})).is_determined);
  EXPECT_FALSE(
      fit_plane_robustly(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).is_determined);
}

TEST(RobustPlaneFit, IgnoresClutterThatPullsLeastSquaresAway) {
  std::mt19937 random{4};
  Points points = noisy_face(random, 600, 0.001);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 400; ++i)  // two fifths stand on one side, as a bracket does
    points.emplace_back((tilted() * Eigen::Vector3d(0.1 * unit(random), 0.05 * unit(random),
                                                    0.02 + 0.2 * unit(random)))
                            .cast<float>());
  points.emplace_back(NAN, NAN, NAN);
  const Eigen::Vector3d truth = tilted().linear().col(2);
  EXPECT_GT(angle_to(fit_plane(points), truth), 0.2);

  const PlaneFit fit = fit_plane_robustly(points, {.noise_m = 0.001});
  ASSERT_TRUE(fit.is_determined);
  EXPECT_NEAR(static_cast<double>(fit.inliers.size()), 600, 10);  // 3 sigma leaves out 1.6 of them
  // 1 mm over 600 points of 29 mm standard spread: 1.4 mrad; four of them.
  EXPECT_LT(angle_to(fit, truth), 0.006);
  EXPECT_NEAR(fit.sigma_m, 0.001, 0.0002);
  for (const std::uint32_t i : fit.inliers) EXPECT_LT(i, 600U);
}

TEST(RobustPlaneFit, FindsItsOwnNoiseAndRepeatsItself) {
  std::mt19937 random{5};
  const Points points = noisy_face(random, 2000, 0.002);
  const PlaneFit a = fit_plane_robustly(points), b = fit_plane_robustly(points);
  ASSERT_TRUE(a.is_determined);
  EXPECT_NEAR(a.sigma_m, 0.002, 0.0002);
  EXPECT_EQ(a.normal(), b.normal());
  EXPECT_EQ(a.inliers, b.inliers);
}

TEST(RobustPlaneFit, RefusesACloudWithoutAPlane) {
  std::mt19937 random{6};
  std::uniform_real_distribution<float> unit(-1, 1);
  Points points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(unit(random), unit(random), unit(random));
  EXPECT_FALSE(fit_plane_robustly(points, {.noise_m = 0.001, .inlier_sigmas = 0.5}).is_determined);
}

TEST(RobustPlaneFit, TakesPointsWithoutAnyNoise) {
  Points points;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      points.emplace_back(0.01F * static_cast<float>(i), 0.01F * static_cast<float>(j), 1.0F);
  const PlaneFit fit = fit_plane_robustly(points);
  ASSERT_TRUE(fit.is_determined);
  EXPECT_EQ(fit.inliers.size(), 900U);
  EXPECT_LT(angle_to(fit, {0, 0, 1}), 1e-6);
}

}  // namespace
}  // namespace spool
