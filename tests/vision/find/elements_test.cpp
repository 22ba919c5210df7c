// Directions of neighbourhoods on a plane, a pipe and things that have none.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/elements.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spool {
namespace {

using Eigen::Vector3f;

const Vector3f kNormal = Vector3f(0.3F, -0.5F, 0.8F).normalized();

// A square of 1 m across kNormal, `spacing` (m) apart, jittered by a third of that, off by noise.
std::vector<Vector3f> plane(float spacing, float noise, std::mt19937& random) {
  std::uniform_real_distribution<float> jitter(-spacing / 3, spacing / 3);
  std::normal_distribution<float> gauss(0, 1);
  const Vector3f u = kNormal.unitOrthogonal();
  const Vector3f v = kNormal.cross(u);
  std::vector<Vector3f> points;
  for (float a = 0; a < 1; a += spacing)
    for (float b = 0; b < 1; b += spacing) {
      const float x = a + jitter(random), y = b + jitter(random), off = noise * gauss(random);
      points.push_back(x * u + y * v + off * kNormal);
    }
  return points;
}

// `share` of the way round a cylinder of 1 m along kNormal.
std::vector<Vector3f> cylinder(float radius, float share, float spacing) {
  const Vector3f u = kNormal.unitOrthogonal();
  const Vector3f v = kNormal.cross(u);
  std::vector<Vector3f> points;
  for (float h = 0; h < 1; h += spacing)
    for (float a = 0; a < 2 * std::numbers::pi_v<float> * share; a += spacing / radius)
      points.push_back(h * kNormal + radius * (std::cos(a) * u + std::sin(a) * v));
  return points;
}

TEST(Elements, OfAPlaneHaveItsNormal) {
  std::mt19937 random{1};
  const auto points = plane(0.02F, 0.001F, random);
  const auto elements = local_elements(points, {ElementKind::kSurface, 0.05, 7});
  EXPECT_GT(elements.size(), points.size() * 9 / 10);
  // 1 mm over some eight to twenty points within 50 mm, root mean square 30 mm apart: 0.5 degrees
  // each way, twice that at a corner; four standard deviations.
  for (const Element& element : elements)
    EXPECT_GT(std::abs(element.direction.dot(kNormal)),
              std::cos(4 * std::numbers::pi_v<float> / 180));
}

TEST(Elements, OfAPipeHaveItsAxisFromHalfOfIt) {
  for (const float share : {0.4F, 1.0F}) {
    const auto points = cylinder(0.02F, share, 0.01F);
    const auto elements = local_elements(points, {ElementKind::kTube, 0.1, 6});
    EXPECT_GT(elements.size(), points.size() / 2) << share;
    for (const Element& element : elements) {
      // The neighbourhood of a point at an end, or seen from one side, leans by its own width over
      // its length: 20 mm over 100 mm at the end.
      EXPECT_GT(std::abs(element.direction.dot(kNormal)), std::cos(0.2F)) << share;
      // The middle of its points lies within the radius of the axis.
      EXPECT_LT(element.point.cross(kNormal).norm(), 0.021F) << share;
    }
  }
}

TEST(Elements, OfASurfaceAreNotOnAHalfPipeNarrowerThanTheNeighbourhood) {
  const auto points = cylinder(0.02F, 0.5F, 0.005F);
  EXPECT_LT(local_elements(points, {ElementKind::kSurface, 0.05, 7}).size(), points.size() / 20);
}

TEST(Elements, OfATubeAreNotOnAPlane) {
  std::mt19937 random{2};
  const auto points = plane(0.02F, 0.0F, random);
  EXPECT_LT(local_elements(points, {ElementKind::kTube, 0.1, 6}).size(), points.size() / 20);
}

// The law that all else rests on: what moves with the points.
TEST(Elements, MoveWithThePoints) {
  auto points = cylinder(0.03F, 0.4F, 0.01F);
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  T.linear() = Eigen::AngleAxisf(2.1F, Vector3f(1, 2, -1).normalized()).toRotationMatrix();
  T.translation() = Vector3f(4, -3, 2);
  const ElementOptions options{ElementKind::kTube, 0.1, 6};
  const auto before = local_elements(points, options);
  for (Vector3f& p : points) p = T * p;
  const auto after = local_elements(points, options);
  // Neighbours at the very edge of the radius fall in or out by rounding.
  ASSERT_NEAR(static_cast<double>(before.size()), static_cast<double>(after.size()),
              0.02 * static_cast<double>(before.size()));
  if (before.size() != after.size()) return;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT((T * before[i].point - after[i].point).norm(), 0.005F);
    EXPECT_GT(std::abs((T.linear() * before[i].direction).dot(after[i].direction)), 0.999F);
  }
}

TEST(Elements, OfPointsWithoutADirectionAreNone) {
  const ElementOptions surface{ElementKind::kSurface, 0.1, 7}, tube{ElementKind::kTube, 0.1, 6};
  for (const auto& options : {surface, tube}) {
    EXPECT_TRUE(local_elements({}, options).empty());
    EXPECT_TRUE(local_elements(std::vector<Vector3f>(1, Vector3f::Zero()), options).empty());
    // All in one place.
    EXPECT_TRUE(local_elements(std::vector<Vector3f>(20, Vector3f::Ones()), options).empty());
  }
  // In one line: an axis, but no normal.
  std::vector<Vector3f> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(0.01F * static_cast<float>(i), 0, 0);
  EXPECT_TRUE(local_elements(line, surface).empty());
  EXPECT_FALSE(local_elements(line, tube).empty());
}

}  // namespace
}  // namespace spool
