// Tests of back-projection: depth counts to metres.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/back_projection.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

Camera camera_640() {
  return {.width = 640, .height = 480, .fx = 575.8, .fy = 574.2, .cx = 319.5, .cy = 239.5};
}

DepthFrame random_frame(const Camera& camera) {
  std::mt19937 random{1};
  std::uniform_int_distribution<int> count(0, 4000);
  DepthFrame frame{.index = 7, .width = camera.width, .height = camera.height};
  frame.depth.resize(static_cast<std::size_t>(camera.width) *
                     static_cast<std::size_t>(camera.height));
  for (auto& depth : frame.depth) {
    const int drawn = count(random);
    depth = static_cast<std::uint16_t>(drawn < 400 ? 0 : drawn);  // a tenth is not measured
  }
  return frame;
}

TEST(BackProjection, FollowsThePinholeFormulaInEveryPixel) {
  const Camera camera = camera_640();
  const DepthFrame frame = random_frame(camera);
  const auto cloud = back_project(frame, camera);
  ASSERT_TRUE(cloud);
  ASSERT_TRUE(cloud->is_consistent());
  EXPECT_TRUE(cloud->pixels.empty());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto i = static_cast<std::size_t>(v * camera.width + u);
      const Eigen::Vector3f& point = cloud->points[i];
      if (frame.depth[i] == 0) {
        ASSERT_TRUE(std::isnan(point.x()) && std::isnan(point.y()) && std::isnan(point.z()));
        continue;
      }
      const double z = frame.depth[i] * 0.001;
      const Eigen::Vector3d exact((u - 319.5) * z / 575.8, (v - 239.5) * z / 574.2, z);
      // Half a unit in the last place of a float near 4 m is 2.4e-7 m.
      ASSERT_LT((point.cast<double>() - exact).cwiseAbs().maxCoeff(), 3e-7) << u << ' ' << v;
    }
}

// A wall 1 m away, bent by the calibration's own polynomial written out here term by term.
TEST(BackProjection, TakesTheCalibrationsWarpOffTheDepth) {
  Camera camera = camera_640();
  camera.depth_unit_m = 0.00002;  // so that rounding to counts is a hundredth of a millimetre
  const double c[12] = {0.006,  -0.002, 0.004,   0.003, -0.001, 0.002,
                        -0.004, 0.002,  -0.0015, 0.001, 0.0005, -0.003};
  std::ranges::copy(c, camera.calibration.warp.share.begin());
  DepthFrame frame{.index = 1, .width = camera.width, .height = camera.height};
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const double x = (u + 0.5 - 320) / 320, y = (v + 0.5 - 240) / 240;
      const double w = c[0] * x * x + c[1] * x * y + c[2] * y * y + c[3] * x * x * x +
                       c[4] * x * x * y + c[5] * x * y * y + c[6] * y * y * y +
                       c[7] * x * x * x * x + c[8] * x * x * x * y + c[9] * x * x * y * y +
                       c[10] * x * y * y * y + c[11] * y * y * y * y;
      frame.depth.push_back(static_cast<std::uint16_t>(std::lround(1.0 * (1 + w) / 0.00002)));
    }
  const auto cloud = back_project(frame, camera);
  ASSERT_TRUE(cloud);
  for (const Eigen::Vector3f& point : cloud->points) ASSERT_NEAR(point.z(), 1, 1.1e-5);
  EXPECT_NEAR(cloud->points.front().x(), -319.5 / 575.8, 1e-5);
}

TEST(BackProjection, ProjectsBackOntoItsOwnPixel) {
  const Camera camera = camera_640();
  const auto cloud = back_project(random_frame(camera), camera);
  ASSERT_TRUE(cloud);
  const PointCloud measured = measured_points(*cloud);
  ASSERT_GT(measured.size(), 200000U);
  ASSERT_EQ(measured.pixels.size(), measured.size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const Eigen::Vector2d pixel = camera.project(measured.points[i].cast<double>());
    ASSERT_NEAR(pixel.x(), measured.pixels[i] % 640,
                1e-3);  // 1e-6 of rounding times the focal length
    ASSERT_NEAR(pixel.y(), measured.pixels[i] / 640, 1e-3);
  }
}

TEST(BackProjection, HonoursTheDepthUnit) {
  Camera camera{.width = 1, .height = 1, .fx = 100, .fy = 100, .cx = 0, .cy = 0};
  camera.depth_unit_m = 0.0001;
  const auto cloud = back_project({.width = 1, .height = 1, .depth = {12345}}, camera);
  ASSERT_TRUE(cloud);
  EXPECT_FLOAT_EQ(cloud->points[0].z(), 1.2345F);
}

TEST(BackProjection, RefusesAFrameOfAnotherSizeAndNamesBoth) {
  const auto cloud =
      back_project({.index = 3, .width = 2, .height = 1, .depth = {1, 2}}, camera_640());
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kBadInput);
  EXPECT_NE(cloud.error().message.find("depth frame 3 is 2x1"), std::string::npos);
  EXPECT_NE(cloud.error().message.find("640x480"), std::string::npos);
}

TEST(BackProjection, RefusesAFrameWithTooFewReadings) {
  DepthFrame frame = random_frame(camera_640());
  frame.depth.pop_back();
  EXPECT_FALSE(back_project(frame, camera_640()));
}

TEST(BackProjection, RefusesIntrinsicsThatAreNotUsable) {
  struct Row {
    const char* name;
    double fx, cx, unit;
  };
  for (const Row& row :
       {Row{"zero focal length", 0, 1, 1e-3}, Row{"not a number", NAN, 1, 1e-3},
        Row{"centre nowhere", 500, NAN, 1e-3}, Row{"negative unit", 500, 1, -1e-3}}) {
    Camera camera = camera_640();
    camera.fx = row.fx;
    camera.cx = row.cx;
    camera.depth_unit_m = row.unit;
    const auto cloud = back_project(random_frame(camera_640()), camera);
    ASSERT_FALSE(cloud) << row.name;
    EXPECT_NE(cloud.error().message.find("intrinsics"), std::string::npos) << row.name;
  }
}

TEST(MeasuredPoints, KeepsNormalsAndPlacesTogether) {
  PointCloud cloud;
  cloud.width = 3;
  cloud.height = 1;
  cloud.points = {{0, 0, 1}, {NAN, NAN, NAN}, {1, 0, 2}};
  cloud.normals = {{0, 0, -1}, {0, 0, 0}, {0, -1, 0}};
  const PointCloud measured = measured_points(cloud);
  ASSERT_EQ(measured.size(), 2U);
  EXPECT_EQ(measured.width, 0);
  EXPECT_EQ(measured.pixels, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(measured.normals[1], Eigen::Vector3f(0, -1, 0));
}

}  // namespace
}  // namespace spool
