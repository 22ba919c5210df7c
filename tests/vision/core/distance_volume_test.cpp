// The look-up in a volume made by hand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/distance_volume.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace spool {
namespace {

// Two grid cubes of 80 mm along x: the first leads to a block of which one eighth (x high, y low, z
// high) is the second brick, the other cube to nothing. The bricks hold x, and min(y, 0.02 - y) as
// its two pieces, in their own cubes.
DistanceVolume volume_by_hand() {
  DistanceVolume volume;
  volume.lowest = {1, 2, 3};
  volume.cell_m = 0.08F;
  volume.band_m = 0.03F;
  volume.grid.size = {2, 1, 1};
  volume.grid.data = {volume_word(VolumeWord::kBlock, 0, 0, 0), 0};
  volume.nodes.size = {2, 2, 2};
  volume.nodes.data.assign(8, 0);
  volume.nodes.data[volume.nodes.place(1, 0, 1)] = volume_word(VolumeWord::kBrick, 1, 0, 0);
  volume.nodes.data[volume.nodes.place(0, 0, 0)] = volume_word(VolumeWord::kBrick, 0, 0, 0);
  volume.bricks.size = {10, 5, 5};
  volume.bricks.data.resize(250);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 5; ++x) {
        const auto step = [](int i) { return 0.01F * static_cast<float>(i); };
        volume.bricks.data[volume.bricks.place(x, y, z)] = {Eigen::half(step(x)),
                                                            Eigen::half(step(x))};
        volume.bricks.data[volume.bricks.place(5 + x, y, z)] = {Eigen::half(step(y)),
                                                                Eigen::half(0.015F - step(y))};
      }
  return volume;
}

constexpr float kHalf = 1e-5F;  // m; half floats near 20 mm

TEST(DistanceVolume, FollowsTheTreeToTheBrick) {
  const DistanceVolume volume = volume_by_hand();
  EXPECT_EQ(volume.brick_count(), 2U);
  EXPECT_EQ(volume.bytes(), 4U * (2 + 8) + 4U * 250);
  const auto first = volume.at({1.0137F, 2.02F, 3.03F});
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->distance_m, 0.0137F, kHalf);
  EXPECT_NEAR((first->outward - Eigen::Vector3f::UnitX()).norm(), 0, 1e-3);
  const auto last = volume.at({1.0F, 2.0F, 3.0F});  // the very corner
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->distance_m, 0, kHalf);
}

TEST(DistanceVolume, TakesTheLesserOfTwoPieces) {
  const DistanceVolume volume = volume_by_hand();
  for (float y = 0; y < 0.0299F; y += 0.0007F) {
    const auto found = volume.at({1.06F, 2 + y, 3.05F});
    ASSERT_TRUE(found) << y;
    const float other = 0.015F - y;
    EXPECT_NEAR(found->distance_m, std::abs(other) < y ? other : y, 2 * kHalf) << y;
    if (std::abs(std::abs(other) - y) < 2 * kHalf) continue;  // either
    EXPECT_NEAR(found->outward.y(), std::abs(other) < y ? -1 : 1, 1e-3) << y;
  }
}

TEST(DistanceVolume, KnowsNothingBeyondItsBandAndItsTree) {
  const DistanceVolume volume = volume_by_hand();
  EXPECT_TRUE(volume.at({1.0299F, 2.01F, 3.01F}));
  EXPECT_FALSE(volume.at({1.0301F, 2.01F, 3.01F})) << "beyond the band";
  EXPECT_FALSE(volume.at({1.01F, 2.05F, 3.01F})) << "an eighth with nothing in it";
  EXPECT_FALSE(volume.at({1.10F, 2.01F, 3.01F})) << "a cube with nothing in it";
  for (const float out : {-1e-3F, 0.17F, 1e9F, std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity()}) {
    EXPECT_FALSE(volume.at({1 + out, 2.01F, 3.01F})) << out;
    EXPECT_FALSE(volume.at({1.01F, 2.01F, 3 + out})) << out;
  }
  EXPECT_FALSE(DistanceVolume().at({0, 0, 0}));
}

}  // namespace
}  // namespace spool
