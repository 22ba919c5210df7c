// Tests of the small value types: camera, units, clouds and frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "vision/core/camera.h"
#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/depth_frame.h"
#include "vision/core/estimate.h"
#include "vision/core/length_unit.h"
#include "vision/core/version.h"

namespace spool {
namespace {

const Camera kCamera{.width = 640, .height = 480, .fx = 575, .fy = 570, .cx = 319.5, .cy = 239.5};

TEST(Camera, ProjectsWhatItBackProjects) {
  for (const double u : {0.0, 319.5, 639.0})
    for (const double v : {0.0, 100.25, 479.0}) {
      const Eigen::Vector2d pixel = kCamera.project(kCamera.back_project(u, v, 1.7));
      EXPECT_NEAR(pixel.x(), u, 1e-12);
      EXPECT_NEAR(pixel.y(), v, 1e-12);
    }
  EXPECT_EQ(kCamera.back_project(319.5, 239.5, 2), Eigen::Vector3d(0, 0, 2));
}

TEST(Camera, KnowsWhatCannotBeOne) {
  EXPECT_TRUE(kCamera.is_valid());
  struct Row {
    const char* name;
    void (*spoil)(Camera&);
  };
  for (const Row& row :
       {Row{"width", [](Camera& c) { c.width = 0; }},
        Row{"height", [](Camera& c) { c.height = 16385; }}, Row{"fx", [](Camera& c) { c.fx = 0; }},
        Row{"fy", [](Camera& c) { c.fy = std::numeric_limits<double>::infinity(); }},
        Row{"cx", [](Camera& c) { c.cx = std::nan(""); }},
        Row{"cy", [](Camera& c) { c.cy = -1e300; }},
        Row{"unit", [](Camera& c) { c.depth_unit_m = 0; }}}) {
    Camera camera = kCamera;
    row.spoil(camera);
    EXPECT_FALSE(camera.is_valid()) << row.name;
  }
}

TEST(LengthUnit, ComesBackFromItsName) {
  for (const LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kMillimetre, LengthUnit::kInch})
    EXPECT_EQ(parse_length_unit(name(unit)), unit);
  EXPECT_EQ(metres(LengthUnit::kInch), 0.0254);
  EXPECT_EQ(metres(LengthUnit::kMillimetre), 0.001);
  for (const char* text : {"", "M", "cm", "mm ", "metre"})
    EXPECT_FALSE(parse_length_unit(text)) << text;
}

TEST(PointCloud, IsConsistentWhenItsArraysMatch) {
  PointCloud cloud;
  EXPECT_TRUE(cloud.is_consistent());
  cloud.points.resize(6);
  EXPECT_TRUE(cloud.is_consistent());
  EXPECT_FALSE(cloud.has_normals());
  cloud.normals.resize(5);
  EXPECT_FALSE(cloud.is_consistent());
  cloud.normals.resize(6);
  EXPECT_TRUE(cloud.has_normals());
  cloud.width = 3;
  cloud.height = 1;
  EXPECT_FALSE(cloud.is_consistent());
  cloud.height = 2;
  EXPECT_TRUE(cloud.is_consistent());
  const CloudView view = cloud;
  EXPECT_EQ(view.size(), 6U);
  EXPECT_TRUE(view.has_normals());
}

TEST(DepthFrame, IsConsistentWhenItHasAReadingForEveryPixel) {
  EXPECT_FALSE(DepthFrame{}.is_consistent());
  EXPECT_TRUE((DepthFrame{.width = 2, .height = 1, .depth = {1, 2}}).is_consistent());
  EXPECT_FALSE((DepthFrame{.width = 2, .height = 2, .depth = {1, 2}}).is_consistent());
  EXPECT_FALSE((DepthFrame{.width = -1, .height = -2, .depth = {1, 2}}).is_consistent());
}

TEST(Estimate, GivesTheRootOfItsVariance) {
  Estimate<2> estimate;
  estimate.covariance(1, 1) = 4e-6;
  EXPECT_DOUBLE_EQ(estimate.u(1), 0.002);
}

TEST(Watch, ReportsAndStops) {
  std::stop_source source;
  double last = 0;
  const Watch watch{source.get_token(),
                    [&](std::string_view, double fraction) { last = fraction; }};
  watch.report("align", 0.5);
  EXPECT_EQ(last, 0.5);
  EXPECT_FALSE(watch.cancelled());
  source.request_stop();
  EXPECT_TRUE(watch.cancelled());
  EXPECT_FALSE(Watch{}.cancelled());
  Watch{}.report("nobody listens", 1.0);
}

TEST(WatchedLoop, CallsForEveryIndexInOrder) {
  for (const std::size_t count : {0U, 1U, 16384U, 40000U}) {
    std::size_t next = 0;
    EXPECT_TRUE(watched_loop(count, Watch{}, [&](std::size_t i) { EXPECT_EQ(i, next++); }));
    EXPECT_EQ(next, count);
  }
}

TEST(WatchedLoop, EndsSoonAfterItIsStopped) {
  std::stop_source stop;
  std::size_t calls = 0;
  EXPECT_FALSE(watched_loop(1000000, Watch{stop.get_token(), {}}, [&](std::size_t i) {
    ++calls;
    if (i == 50000) stop.request_stop();
  }));
  EXPECT_GT(calls, 50000U);
  EXPECT_LT(calls, 100000U);  // calls of a microsecond: a twentieth of a second
}

TEST(Version, IsSaid) {
  EXPECT_FALSE(version().empty());
  EXPECT_FALSE(commit().empty());
}

}  // namespace
}  // namespace spool
