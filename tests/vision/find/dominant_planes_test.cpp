// Floor and walls are found, and no face of the design passes for one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/dominant_planes.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/find/room.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kNoise = 0.002;  // m

struct Plane {
  Vector3d normal;
  double offset = 0;
};

bool is_among(const std::vector<DominantPlane>& planes, const Plane& truth) {
  return std::any_of(planes.begin(), planes.end(), [&](const DominantPlane& plane) {
    const double along = plane.normal.cast<double>().dot(truth.normal);
    // 2 mm of noise over thousands of points in metres: far under a milliradian, but patches of
    // other things within the band lean on it.
    return std::abs(along) > std::cos(0.005) &&
           std::abs((along > 0 ? 1 : -1) * double{plane.offset} - truth.offset) < 0.01;
  });
}

// Floor, two walls and a table that is larger than the design, the floor sloped as said.
TEST(DominantPlanes, FindFloorAndWallsHoweverTheScanLies) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random{seed};
    std::vector<Vector3f> points;
    const double slope = 0.1 * seed;
    test::add_rectangle(points, {0, 0, 0}, {5, 0, 5 * slope}, {0, 4, 0}, 900, kNoise, random);
    test::add_rectangle(points, {0, 4, 0}, {5, 0, 0}, {0, 0, 2.5}, 900, kNoise, random);
    test::add_rectangle(points, {0, 0, 0}, {0, 4, 0}, {0, 0, 2.5}, 900, kNoise, random);
    const Pose T = test::random_motion(10, 1.5, random);
    for (Vector3f& p : points) p = T.cast<float>() * p;
    const auto planes = dominant_planes(points, {.size_m = 0.8, .noise_m = kNoise});
    EXPECT_EQ(planes.size(), 3U) << "seed " << seed;
    for (const Vector3d& normal :
         {Vector3d(-slope, 0, 1).normalized(), Vector3d(0, 1, 0), Vector3d(1, 0, 0)}) {
      const Vector3d through = T * Vector3d(0, normal.y() > 0.5 ? 4 : 0, 0);
      const Vector3d turned = T.linear() * normal;
      EXPECT_TRUE(is_among(planes, {turned, turned.dot(through)}))
          << seed << ": " << normal.transpose();
    }
    for (std::size_t i = 0; i + 1 < planes.size(); ++i)
      EXPECT_GE(planes[i].points, planes[i + 1].points) << "the largest first";
    // All that is left lies off the planes: next to nothing here.
    const auto off = off_planes(points, planes, 4 * kNoise);
    EXPECT_LT(off.size(), points.size() / 500);
  }
}

// The frame round an opening: all of a shape's points may lie at its rim, where they spread wider
// than the points of a full sheet as long.
void add_frame(std::vector<Vector3f>& points, double length, double width, double bar,
               std::mt19937& random) {
  for (const double y : {0.0, width - bar})
    test::add_rectangle(points, {0, y, 0}, {length, 0, 0}, {0, bar, 0}, 20000, kNoise, random);
  for (const double x : {0.0, length - bar})
    test::add_rectangle(points, {x, bar, 0}, {bar, 0, 0}, {0, width - 2 * bar, 0}, 20000, kNoise,
                        random);
}

TEST(DominantPlanes, AreNeverADesignsOwnFace) {
  struct Face {
    const char* name;
    double length, width;  // m; nothing but this face is scanned
    double bar;            // m; of a frame, 0: a full plate
  };
  for (const Face& face :
       {Face{"square plate", 1, 1, 0}, Face{"plate", 1, 0.6, 0}, Face{"square frame", 1, 1, 0.06},
        Face{"frame two to one", 1, 0.5, 0.06}, Face{"frame three to two", 1, 0.67, 0.06}}) {
    std::mt19937 random{5};
    std::vector<Vector3f> points;
    if (face.bar > 0) {
      add_frame(points, face.length, face.width, face.bar, random);
    } else {
      test::add_rectangle(points, {0, 0, 0}, {face.length, 0, 0}, {0, face.width, 0}, 20000, kNoise,
                          random);
    }
    // A flat thing: the face's diagonal is the design's size.
    const double size = std::hypot(face.length, face.width);
    EXPECT_TRUE(dominant_planes(points, {.size_m = size, .noise_m = kNoise}).empty()) << face.name;
  }
}

TEST(DominantPlanes, AreNotThePlanesThatTouchManySmallThings) {
  // Forty boxes of one height, half their width apart, all over 3 x 2 m: their tops are in one
  // plane, but each is a face of its own.
  std::mt19937 random{6};
  std::vector<Vector3f> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 5; ++j)
      test::add_rectangle(points, {0.4 * i, 0.4 * j, 0.3}, {0.2, 0, 0}, {0, 0.2, 0}, 20000, kNoise,
                          random);
  EXPECT_TRUE(dominant_planes(points, {.size_m = 0.8, .noise_m = kNoise}).empty());
}

TEST(DominantPlanes, AreNoneInNothingAndInNoise) {
  EXPECT_TRUE(dominant_planes({}, {}).empty());
  EXPECT_TRUE(dominant_planes(std::vector<Vector3f>(1, Vector3f::Zero()), {}).empty());
  EXPECT_TRUE(dominant_planes(std::vector<Vector3f>(5000, Vector3f::Ones()), {}).empty());
  std::mt19937 random{7};
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Vector3f> noise, line;
  for (int i = 0; i < 20000; ++i) {
    const float x = unit(random), y = unit(random), z = unit(random);
    noise.emplace_back(4 * x, 4 * y, 4 * z);
    line.emplace_back(20 * x, 0, 0);
  }
  EXPECT_TRUE(dominant_planes(noise, {.size_m = 0.8, .noise_m = kNoise}).empty());
  EXPECT_TRUE(dominant_planes(line, {.size_m = 0.8, .noise_m = kNoise}).empty());
  EXPECT_EQ(off_planes(noise, {}, 0.01).size(), noise.size());
}

}  // namespace
}  // namespace spool
