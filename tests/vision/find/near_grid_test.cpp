// Tests of the grid that says what is near a cloud, against the distances themselves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/near_grid.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(NearGrid, AgreesWithTheDistancesButForItsSlack) {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Eigen::Vector3f> points(200);
  for (auto& p : points) p = {5 + unit(random), unit(random), -3 + unit(random)};
  points[3].y() = NAN;
  const NearGrid grid(points, 0.1);
  EXPECT_EQ(grid.distance_m(), 0.1);
  EXPECT_NEAR(grid.slack_m(), 0.0433, 1e-3);  // half the diagonal of a cell of 0.05
  int near = 0, far = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3f q = {4.7F + 1.6F * unit(random), -0.3F + 1.6F * unit(random),
                               -3.3F + 1.6F * unit(random)};
    double distance = INFINITY;
    for (const auto& p : points)
      if (p.allFinite()) distance = std::min(distance, static_cast<double>((p - q).norm()));
    if (distance < 0.1 - grid.slack_m() - 1e-5) {
      ++near;
      EXPECT_TRUE(grid.is_near(q)) << distance;
    } else if (distance > 0.1 + grid.slack_m() + 1e-5) {
      ++far;
      EXPECT_FALSE(grid.is_near(q)) << distance;
    }
  }
  EXPECT_GT(near, 500);
  EXPECT_GT(far, 500);
}

TEST(NearGrid, NothingIsNearNothingAndNothingThatIsNoPlace) {
  EXPECT_FALSE(NearGrid().is_near({0, 0, 0}));
  const std::vector<Eigen::Vector3f> none = {{NAN, 0, 0}};
  EXPECT_FALSE(NearGrid(none, 1).is_near({0, 0, 0}));
  const std::vector<Eigen::Vector3f> one = {{1, 1, 1}};
  const NearGrid grid(one, 0.1);
  EXPECT_TRUE(grid.is_near({1, 1, 1}));
  EXPECT_FALSE(grid.is_near({NAN, 1, 1}));
  EXPECT_FALSE(grid.is_near({INFINITY, 1, 1}));
  EXPECT_FALSE(grid.is_near({-1e30F, 1, 1}));
}

TEST(NearGrid, CoarsensRatherThanFillTheMemory) {
  const std::vector<Eigen::Vector3f> far = {{0, 0, 0}, {1e6F, 2e6F, 3e37F}, {5e6F, 1, 1}};
  const NearGrid grid(far, 0.01);
  EXPECT_GT(grid.distance_m(), 1e30);
  for (const auto& p : far) EXPECT_TRUE(grid.is_near(p)) << p.transpose();
}

}  // namespace
}  // namespace spool
