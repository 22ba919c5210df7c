// The noise found in a cloud is the noise that was put in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/noise_estimate.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

// A half pipe of `radius` and a metre's length, `spacing` apart, moved off its surface by `sigma`
// (all m).
std::vector<Eigen::Vector3f> half_pipe(double radius, double spacing, double sigma) {
  std::mt19937 random{1};
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<Eigen::Vector3f> points;
  for (double z = 0; z < 1; z += spacing)
    for (double angle = 0; angle < std::numbers::pi; angle += spacing / radius) {
      const double r = radius + sigma * noise(random);
      points.emplace_back(
          Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
    }
  return points;
}

TEST(EstimateNoise, FindsItOnCurvedPipe) {
  for (const double sigma : {0.0005, 0.002}) {
    // An NPS 4 pipe; spacing well over the noise, as scanners sample. The median of 2000 residuals
    // of 18 degrees of freedom is good to a per cent; choosing neighbours by distance costs some
    // more.
    EXPECT_NEAR(estimate_noise(CloudView(half_pipe(0.057, 0.005, sigma))), sigma, 0.15 * sigma)
        << sigma;
  }
}

TEST(EstimateNoise, IsNotMovedByEdgesAndStrayPoints) {
  auto points = half_pipe(0.057, 0.005, 0.001);
  std::mt19937 random{2};
  std::uniform_real_distribution<float> anywhere(-1.0F, 1.0F);
  for (std::size_t i = points.size() / 5; i > 0; --i)
    points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
  EXPECT_NEAR(estimate_noise(CloudView(points)), 0.001, 0.0003);
}

TEST(EstimateNoise, IgnoresPointsThatAreNone) {
  auto points = half_pipe(0.057, 0.005, 0.001);
  const double before = estimate_noise(CloudView(points));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  points.insert(points.begin(), 100, Eigen::Vector3f(nan, nan, nan));
  EXPECT_EQ(estimate_noise(CloudView(points)), before);
}

TEST(EstimateNoise, NeverClaimsLessThanPaintAndScale) {
  EXPECT_EQ(estimate_noise(CloudView(half_pipe(0.057, 0.005, 0.0))), 1e-4);
  EXPECT_EQ(estimate_noise(CloudView()), 1e-4);
  const std::vector<Eigen::Vector3f> same(1000, Eigen::Vector3f::Ones());
  EXPECT_EQ(estimate_noise(CloudView(same)), 1e-4);
}

}  // namespace
}  // namespace spool
