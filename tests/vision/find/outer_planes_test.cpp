// What ends a scan, and what only lies in it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/outer_planes.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/find/room.h"
#include "vision/find/find_scene.h"
#include "vision/find/pose_evidence.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kNoise = 0.002;         // m
constexpr double kBand = 0.012;          // m
constexpr double kFloor = 0, kWall = 2;  // m, z and y

// Floor, a wall and a table 0.8 m high; the room moved by T.
struct Hall {
  std::vector<Vector3f> points;
  std::vector<DominantPlane> planes;

  explicit Hall(const Pose& T, std::size_t behind_wall = 0) {
    std::mt19937 random{4};
    test::add_rectangle(points, {-3, -2, kFloor}, {6, 0, 0}, {0, 4, 0}, 900, kNoise, random);
    test::add_rectangle(points, {-3, kWall, 0}, {6, 0, 0}, {0, 0, 2.5}, 900, kNoise, random);
    test::add_rectangle(points, {-1.5, -0.7, 0.8}, {3, 0, 0}, {0, 1.4, 0}, 2000, kNoise, random);
    for (std::size_t i = 0; i < behind_wall; ++i)
      points.emplace_back(0.001F * static_cast<float>(i), 2.5F, 1.0F);
    for (Vector3f& p : points) p = T.cast<float>() * p;
    planes = dominant_planes(points, {.size_m = 0.8, .noise_m = kNoise});
  }
};

TEST(OuterPlanes, AreFloorAndWallButNoTableHoweverTheScanLies) {
  std::mt19937 random{1};
  for (int turn = 0; turn < 6; ++turn) {
    const Pose T = test::random_motion(5, 3, random);
    const Hall hall(T);
    ASSERT_EQ(hall.planes.size(), 3U);
    const auto outer = outer_planes(hall.points, hall.planes, kBand);
    ASSERT_EQ(outer.size(), 2U);
    const auto behind = [&](const Vector3d& place) {
      return is_behind(outer, (T * place).cast<float>(), kBand);
    };
    EXPECT_TRUE(behind({0, 0, kFloor - 0.1}));
    EXPECT_TRUE(behind({0, kWall + 0.1, 1}));
    EXPECT_FALSE(behind({0, 0, kFloor + 0.1}));
    EXPECT_FALSE(behind({0, kWall - 0.1, 1}));
    EXPECT_FALSE(behind({0, 0, 0.7})) << "below the table is room enough";
    EXPECT_FALSE(behind({0, 0, kFloor - 0.5 * kBand})) << "a reading's noise";
    EXPECT_FALSE(behind({5, 0, kFloor - 0.1})) << "nobody saw a floor there";
  }
}

TEST(OuterPlanes, AreNoneThroughWhichMoreIsSeen) {
  // A door: a hundred points behind the wall of some 38 000.
  EXPECT_EQ(
      outer_planes(Hall(Pose::Identity(), 100).points, Hall(Pose::Identity(), 100).planes, kBand)
          .size(),
      2U);
  const Hall open(Pose::Identity(), 400);
  EXPECT_EQ(outer_planes(open.points, open.planes, kBand).size(), 1U);
  EXPECT_TRUE(outer_planes({}, {}, kBand).empty());
  EXPECT_FALSE(is_behind({}, Vector3f::Zero(), kBand));
}

// The same spool on the same points, above the floor and reaching through it.
TEST(OuterPlanes, SpeakAgainstAPoseThatReachesThroughThem) {
  const FinderModel model = test::finder_of(test::design_of(test::tee_spool()), 4000);
  const Hall hall(Pose::Identity());
  std::mt19937 random{2};
  const auto weigh = [&](double height) {
    Pose T = Pose::Identity();
    T.translation() = Vector3d(0, -1.4, height);
    std::vector<Vector3f> points = hall.points;
    const PointCloud some =
        test::scan_of(test::tee_spool(), T, {.points = 8000, .noise_m = kNoise}, random);
    // What is below the floor the scanner did not see.
    for (const Vector3f& p : some.points)
      if (p.z() > 0.03F) points.push_back(p);
    const FindScene scene(model, points, kNoise, {});
    EXPECT_EQ(scene.outer().size(), 2U);
    return weigh_pose(model, scene, T.inverse().cast<float>(), 0.006);
  };
  const PoseEvidence above = weigh(0.5);
  EXPECT_EQ(above.behind, 0);
  const PoseEvidence through = weigh(-0.2);
  EXPECT_GT(through.behind, 0.1);
  EXPECT_LT(through.behind, 0.9);
  EXPECT_NEAR(through.excess(),
              (static_cast<double>(through.explained) - through.chance) * (1 - through.behind),
              1e-6);
}

}  // namespace
}  // namespace spool
