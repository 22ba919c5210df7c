// The floor is told from what ends there, and from what only sticks out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/ground.h"

#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kSize = 1.5, kBand = 0.02;  // m

// Posts of several heights that all end at z = 0, which nobody scanned, and a bar above them.
std::vector<Vector3f> posts(int count, const Pose& T, const std::vector<test::Rod>& more = {}) {
  std::mt19937 random{9};
  std::vector<test::Rod> rods = more;
  rods.push_back({{-0.8, 0, 1}, Vector3d::UnitX(), 0.05, 1.6});
  for (int i = 0; i < count; ++i)
    rods.push_back({{-1.0 + 0.5 * (i % 5), 0.7 * (i / 5) - 0.5, 0},
                    Vector3d::UnitZ(),
                    0.06,
                    0.4 + 0.1 * (i % 3)});
  return test::scan_of(rods, T, {.points = 30000, .noise_m = 0.002, .with_ends = false}, random)
      .points;
}

TEST(Ground, IsWhereManyThingsEndHoweverTheScanLies) {
  std::mt19937 random{2};
  std::normal_distribution<double> gauss;
  for (int turn = 0; turn < 5; ++turn) {
    const Pose T = test::random_motion(3, 2, random);
    std::vector<Vector3f> points = posts(12, T);
    points.push_back((T * Vector3d(0.3, 0, -2)).cast<float>());  // a stray
    const Vector3d down =
        T.linear() * (Vector3d(0.2 * gauss(random), 0.1 * gauss(random), -1)).normalized();
    const auto plane = ground(points, points, down.cast<float>(), kSize, kBand);
    ASSERT_TRUE(plane) << turn;
    EXPECT_GT((T.linear() * Vector3d::UnitZ()).cast<float>().dot(plane->normal), 0.9999F);
    // The lowest of each post's points: the fit lies in the middle of a band of 20 mm.
    EXPECT_NEAR(plane->distance((T * Vector3d(0, 0, 0)).cast<float>()), -0.01, 0.01);
    EXPECT_TRUE(plane->patch.is_near((T * Vector3d(-1.0, -0.5, 0)).cast<float>()));
  }
}

TEST(Ground, IsNotMadeByWhatSticksOut) {
  // One rod that sticks out beyond a bar: hull facets meet at its tip, along the bar's edge.
  const std::vector<test::Rod> rod{{{0, 0, 1}, -Vector3d::UnitZ(), 0.03, 0.6}};
  const auto points = posts(0, Pose::Identity(), rod);
  EXPECT_FALSE(ground(points, points, -Vector3f::UnitZ(), kSize, kBand));
  // Among many things that end elsewhere it is not they that end there.
  const auto floor = posts(12, Pose::Identity());
  EXPECT_FALSE(ground(floor, points, -Vector3f::UnitZ(), kSize, kBand)) << "no witness ends there";
  EXPECT_FALSE(ground({}, {}, -Vector3f::UnitZ(), kSize, kBand));
  const std::vector<Vector3f> same(500, Vector3f(1, 2, 3));
  EXPECT_FALSE(ground(same, same, -Vector3f::UnitZ(), kSize, kBand));
}

}  // namespace
}  // namespace spool
