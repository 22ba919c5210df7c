// Tests of the patches' scatter: nothing where readings are independent, what they share where not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/patch_scatter.h"

#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

PatchScatter scatter_of(double shared_m, double correlated, std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  PatchScatter scatter;
  for (int patch = 0; patch < 40; ++patch) {
    const double off = shared_m * normal(random);
    for (int i = 0; i < 50; ++i) scatter.add(patch, off + 0.002 * normal(random));
  }
  scatter.finish(0, correlated);
  return scatter;
}

TEST(PatchScatter, FindsWhatPatchesErrByTogether) {
  std::mt19937 random{1};
  for (const double shared_m : {0.0, 0.0005, 0.001}) {
    ScatterPool pool;
    for (int i = 0; i < 30; ++i) pool.add(scatter_of(shared_m, 1, random));
    // 1200 patches of 50 readings: a variance good to 4 % of (0.28 mm)^2 + shared^2.
    EXPECT_NEAR(pool.error_m(), shared_m, shared_m > 0 ? 0.06e-3 : 0.1e-3) << shared_m;
    const double expected = 1 + shared_m * shared_m * 50 / (0.002 * 0.002);
    EXPECT_NEAR(pool.birge(), expected, 0.15 * expected) << shared_m;
  }
}

TEST(PatchScatter, ReadingsWorthOneTogetherAreExpectedToScatter) {
  std::mt19937 random{2};
  const PatchScatter scatter = scatter_of(0.001, 30, random);
  EXPECT_EQ(scatter.birge(), 1) << "30 readings worth one scatter by more than 1 mm";
  EXPECT_LT(scatter.excess_m2(), 0);
}

TEST(PatchScatter, SaysNothingOfTooFewReadings) {
  PatchScatter scatter;
  for (int patch = 0; patch < 8; ++patch)
    for (int i = 0; i < 4; ++i) scatter.add(patch, 0.01 * i);
  scatter.finish(5, 1);
  EXPECT_EQ(scatter.patches(), 0U);
  EXPECT_EQ(scatter.birge(), 1);
  EXPECT_EQ(scatter.freedom(), 0);
}

}  // namespace
}  // namespace spool
