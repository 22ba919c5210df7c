// The bit grid against brute-force distances; far points and what is not finite do it no harm.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/occupancy.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

using Eigen::Vector3f;

constexpr double kNear = 0.045;        // m
constexpr double kCell = kNear / 1.5;  // m, as occupancy.h has it
const Vector3f kMiddle(0.3F, -0.2F, 1);

std::vector<Vector3f> ball(std::size_t count, float radius, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<Vector3f> points;
  while (points.size() < count) {
    const float x = unit(random), y = unit(random), z = unit(random);
    points.push_back(kMiddle + radius * Vector3f(x, y, z));
  }
  return points;
}

// Near is near to within a cell, whatever else the scan holds.
void expect_near_to_within_a_cell(const Occupancy& occupancy, const std::vector<Vector3f>& points,
                                  std::mt19937& random) {
  std::size_t near = 0, far = 0;
  for (const Vector3f& query : ball(40000, 0.45F, random)) {
    float distance = std::numeric_limits<float>::infinity();
    for (const Vector3f& p : points) distance = std::min(distance, (p - query).norm());
    if (double{distance} < kNear - kCell) {
      ++near;
      ASSERT_TRUE(occupancy.is_near(query)) << distance;
    } else if (double{distance} > kNear + kCell) {
      ++far;
      ASSERT_FALSE(occupancy.is_near(query)) << distance;
    }
  }
  EXPECT_GT(near, 20U);
  EXPECT_GT(far, 5000U);
}

TEST(Occupancy, AgreesWithBruteForceToWithinACell) {
  std::mt19937 random{1};
  const std::vector<Vector3f> points = ball(150, 0.4F, random);
  expect_near_to_within_a_cell(Occupancy(points, kNear), points, random);
}

struct Stray {
  const char* name;
  float far;  // m
};

class Strays : public testing::TestWithParam<Stray> {};

// A lidar's stray return, a file's sentinel: whatever lies there, the scan is looked at as closely.
TEST_P(Strays, CostNoDetail) {
  std::mt19937 random{2};
  const std::vector<Vector3f> points = ball(150, 0.4F, random);
  const float far = GetParam().far;
  std::vector<Vector3f> with = points;
  with.emplace_back(far, far, far);
  with.emplace_back(-far, 0, far);
  with.emplace_back(0, -far, -far);
  std::shuffle(with.begin(), with.end(), random);
  expect_near_to_within_a_cell(Occupancy(with, kNear), points, random);
}

INSTANTIATE_TEST_SUITE_P(
    Distances, Strays,
    testing::Values(Stray{"a_hall", 100.0F}, Stray{"a_town", 5e4F}, Stray{"the_sun", 1e11F},
                    Stray{"the_largest_float", std::numeric_limits<float>::max()},
                    Stray{"nan", std::numeric_limits<float>::quiet_NaN()},
                    Stray{"infinity", std::numeric_limits<float>::infinity()}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Occupancy, SaysNoToWhatIsNotFiniteOrFarOutside) {
  std::mt19937 random{3};
  const Occupancy occupancy(ball(100, 0.4F, random), kNear);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Vector3f& query : {Vector3f(nan, 0, 0), Vector3f(0, 0, nan), Vector3f(infinity, 0, 0),
                                Vector3f(0, -infinity, 0), Vector3f(3e38F, 3e38F, 3e38F),
                                Vector3f(-1e9F, 0, 0), Vector3f(0, 0, 50)})
    EXPECT_FALSE(occupancy.is_near(query)) << query.transpose();
}

TEST(Occupancy, OfNothingIsNearNothing) {
  EXPECT_FALSE(Occupancy().is_near(Vector3f::Zero()));
  EXPECT_FALSE(Occupancy({}, kNear).is_near(Vector3f::Zero()));
  const std::vector<Vector3f> nothing(5,
                                      Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(Occupancy(nothing, kNear).is_near(Vector3f::Zero()));
}

// A hall of 60 x 40 x 10 m at 3 mm: what is empty takes no room, and every point is near itself.
TEST(Occupancy, HoldsAHallAtAFineCell) {
  std::mt19937 random{4};
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Vector3f> points;
  for (int i = 0; i < 20000; ++i) {
    const float x = unit(random), y = unit(random);
    points.emplace_back(60 * x, 40 * y, i % 2 == 0 ? 0.0F : 10.0F);
  }
  const Occupancy occupancy(points, 0.0045);
  std::size_t between = 0;
  for (const Vector3f& p : points) {
    EXPECT_TRUE(occupancy.is_near(p));
    between += occupancy.is_near(p + Vector3f(0, 0, 0.02F)) ? 1U : 0U;
  }
  EXPECT_EQ(between, 0U);
}

}  // namespace
}  // namespace spool
