// Tests of the sensor's warp by what is flat: walls made by intersecting rays with a plane.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/measure/sensor_check.h"
#include "vision/measure/warp_check.h"
#include "vision/scan/reading_noise.h"

namespace spool {
namespace {

constexpr int kWidth = 320, kHeight = 240;

Camera camera_320() {
  return {.width = kWidth, .height = kHeight, .fx = 288, .fy = 288, .cx = 159.5, .cy = 119.5};
}

struct Wall {
  double distance_m = 1, lean = 0.1;  // along z; of the normal, to the right
  double bend = 0;                    // share of depth in the corners, by r^2 from the middle
  std::uint32_t seed = 1;
};

// Every pixel of the picture: z of the plane, bent, with noise that windows of 4 px share (as many
// as 8 px of a 575 px lens).
PointCloud picture_of(const Wall& wall) {
  std::mt19937 random(wall.seed);
  std::normal_distribution<double> normal;
  std::vector<double> shared(std::size_t{kWidth / 4} * (kHeight / 4));
  for (double& each : shared) each = normal(random);
  PointCloud cloud;
  cloud.width = kWidth;
  cloud.height = kHeight;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const double a = (u - 159.5) / 288, b = (v - 119.5) / 288;
      double z = wall.distance_m / (1 + wall.lean * a);
      const double x = (u - 159.5) / 160, y = (v - 119.5) / 120;
      z *= 1 + wall.bend * (x * x + y * y) / 2;
      const double sigma = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
      z += sigma * shared[static_cast<std::size_t>((v / 4) * (kWidth / 4) + u / 4)];
      cloud.points.push_back(Eigen::Vector3d(a * z, b * z, z).cast<float>());
    }
  return cloud;
}

std::optional<WarpCheck> checked(const PointCloud& cloud, double warp_u_m) {
  return check_warp(cloud.points, {},
                    {.warp_u_m = warp_u_m, .correlated = correlated_readings(camera_320(), 1)});
}

TEST(SensorCheck, FindsABendAndHandsOutWhatTakesItOff) {
  SensorCheck check(camera_320(), {});
  for (std::uint32_t seed = 1; seed <= 8; ++seed)
    ASSERT_TRUE(check.add(picture_of({.bend = 0.01, .seed = seed})));
  const SensorCheckResult result = check.finish(0.004);
  EXPECT_EQ(result.calibration.scale_u, 0.004);  // a wall tells no scale
  EXPECT_EQ(result.frames, 8U);
  EXPECT_NEAR(result.range_m, 1, 0.02);
  EXPECT_NEAR(result.corner_m, 0.010, 3 * result.corner_u_m);
  EXPECT_LT(result.corner_u_m, 0.003);
  // The whole picture, not just the corners.
  for (double x = -1; x <= 1; x += 0.25)
    for (double y = -1; y <= 1; y += 0.25)
      EXPECT_NEAR(result.calibration.warp.at(x, y), 0.005 * (x * x + y * y), 0.0025) << x << y;
  // What is drawn by the model has the model's noise.
  EXPECT_NEAR(result.noise_ratio, 1, 0.1);
  ASSERT_EQ(result.serves.size(), 3U);
  for (const ServedTolerance& each : result.serves)
    for (std::size_t i = 1; i < each.at.size(); ++i)
      EXPECT_LE(each.at[i].longest_m, each.at[i - 1].longest_m);  // never better from further off
}

TEST(SensorCheck, CoversTheTrueBendAsOftenAsItSays) {
  constexpr int kSeeds = 60;
  int within = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SensorCheck check(camera_320(), {});
    ASSERT_TRUE(check.add(picture_of({.bend = 0.006, .seed = static_cast<std::uint32_t>(seed)})));
    const SensorCheckResult result = check.finish(0.005);
    // One corner of the four, so that the largest is not picked.
    within += std::abs(result.calibration.warp.at(1, 1) - 0.006) * result.range_m <
                      2 * result.calibration.warp_u_m
                  ? 1
                  : 0;
  }
  EXPECT_GE(within, 0.9 * kSeeds);
}

TEST(SensorCheck, RefusesWhatIsNoWall) {
  PointCloud nothing = picture_of({});
  for (Eigen::Vector3f& p : nothing.points) p.setConstant(std::nanf(""));
  PointCloud corner = picture_of({});
  for (std::size_t i = 0; i < corner.points.size(); ++i)
    if (i % kWidth < 150) corner.points[i] *= 1.5F;
  for (const PointCloud& cloud : {nothing, corner}) {
    SensorCheck check(camera_320(), {});
    const Status status = check.add(cloud);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::kBadInput);
    EXPECT_NE(status.error().message.find("bare floor or wall"), std::string::npos);
  }
}

TEST(WarpCheck, ContradictsFiveMillimetresInTheCorners) {
  constexpr int kSeeds = 60;
  for (const double bend : {0.005, -0.005}) {
    int count = 0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      const auto check =
          checked(picture_of({.bend = bend, .seed = static_cast<std::uint32_t>(seed)}), 0.0003);
      ASSERT_TRUE(check);
      count += check->is_contradicted ? 1 : 0;
    }
    EXPECT_GE(count, 0.95 * kSeeds) << bend;
  }
}

TEST(WarpCheck, LeavesAFlatPictureAndAKnownBendAlone) {
  constexpr int kSeeds = 60;
  int flat = 0, known = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const auto number = static_cast<std::uint32_t>(seed);
    flat += checked(picture_of({.seed = number}), 0)->is_contradicted ? 1 : 0;
    known += checked(picture_of({.bend = 0.005, .seed = number}), 0.005)->is_contradicted ? 1 : 0;
  }
  // 1 in 100: of 60 more than three come once in 300 times.
  EXPECT_LE(flat, 3);
  EXPECT_LE(known, 3);
}

TEST(WarpCheck, SaysNothingWithoutAPlane) {
  EXPECT_FALSE(checked(PointCloud{}, 0));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anywhere(0.5F, 2.0F);
  PointCloud cloud = picture_of({});
  for (Eigen::Vector3f& p : cloud.points) p *= anywhere(random);
  EXPECT_FALSE(checked(cloud, 0));
}

}  // namespace
}  // namespace spool
