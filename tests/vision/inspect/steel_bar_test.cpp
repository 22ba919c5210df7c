// A bar out of the spool has its line and its part, whichever side of it was seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/steel_bar.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"

namespace spool {
namespace {

using Eigen::Vector3f;
using test::jointed;

// Points on a round bar of radius 20 mm from `from` on, on the half of it that looks to
// `seen_from`.
std::vector<Vector3f> half_of_a_bar(const Vector3f& from, const Vector3f& direction, float length,
                                    const Vector3f& seen_from, float noise_m = 0.001F) {
  std::mt19937 random{5};
  std::uniform_real_distribution<float> along(0, length), half(-0.5F, 0.5F);
  std::normal_distribution<float> noise(0, noise_m);
  const Vector3f front = (seen_from - seen_from.dot(direction) * direction).normalized();
  const Vector3f side = direction.cross(front);
  std::vector<Vector3f> points;
  for (int i = 0; i < 800; ++i) {
    const float angle = std::numbers::pi_v<float> * half(random);
    const float radius = 0.02F + noise(random);
    points.push_back(from + along(random) * direction +
                     radius * (std::cos(angle) * front + std::sin(angle) * side));
  }
  return points;
}

// The riser stands on z with a radius of 30 mm.
TEST(SteelBar, ComesOutOfItsPart) {
  for (const Vector3f& seen_from :
       {Vector3f(0, 1, 0.2F), Vector3f(0.3F, -1, 1), Vector3f(1, 1, -1)}) {
    const Vector3f direction = Vector3f(1, 0, 0.6F).normalized();
    const auto bar = bar_out_of(
        jointed().surface, half_of_a_bar(Vector3f(0.03F, 0, 0.55F), direction, 0.2F, seen_from));
    ASSERT_TRUE(bar);
    EXPECT_EQ(bar->part, test::kRiser);
    EXPECT_GT(bar->direction.dot(direction), 0.998F);
    EXPECT_NEAR(bar->length_m, 0.2F, 0.02F);
    const Vector3f off = bar->joined - Vector3f(0, 0, 0.53F);
    EXPECT_LT((off - off.dot(direction) * direction).norm(), 0.01F);
    EXPECT_NEAR(bar->along(bar->joined + 0.1F * direction), 0.1F, 0.001F);
  }
}

TEST(SteelBar, DoesNotLieBesideTheSteel) {
  const Vector3f direction = Vector3f(1, 0, -1).normalized();
  EXPECT_FALSE(bar_out_of(jointed().surface,
                          half_of_a_bar({0, 0.052F, 0.5F}, direction, 0.4F, Vector3f(0, 1, 0))));
}

TEST(SteelBar, IsNoPlateNoLumpAndNotAFewPoints) {
  std::mt19937 random{6};
  std::uniform_real_distribution<float> in(0, 1);
  std::vector<Vector3f> plate, lump;
  for (int i = 0; i < 800; ++i) {
    plate.emplace_back(0.03F + 0.3F * in(random), 0.05F * in(random), 0.5F);
    lump.push_back(Vector3f(0.08F, 0, 0.5F) +
                   0.05F *
                       Vector3f(in(random)-0.5F, in(random)-0.5F, in(random)-0.5F).normalized());
  }
  EXPECT_FALSE(bar_out_of(jointed().surface, plate));
  EXPECT_FALSE(bar_out_of(jointed().surface, lump));
  const auto bar = half_of_a_bar({0.03F, 0, 0.5F}, Vector3f::UnitX(), 0.2F, Vector3f(0, 1, 0));
  EXPECT_TRUE(bar_out_of(jointed().surface, bar));
  EXPECT_FALSE(bar_out_of(jointed().surface, std::span(bar).first(20)));
  EXPECT_FALSE(bar_out_of(jointed().surface, std::vector<Vector3f>(100, Vector3f::Zero())));
}

}  // namespace
}  // namespace spool
