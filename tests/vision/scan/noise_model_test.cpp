// Tests of the sensor's noise model against the published table.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/noise_model.h"

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(NoiseModel, GivesThePublishedAxialAndLateralValuesHeadOn) {
  struct Row {
    double z_m, axial_mm, lateral_mm;  // lateral at 575 px
  };
  const NoiseModel noise;
  for (const Row& row : {Row{0.4, 1.20, 0.56}, Row{0.8, 1.50, 1.11}, Row{1.2, 2.42, 1.67},
                         Row{2.0, 6.06, 2.78}, Row{3.0, 14.0, 4.17}}) {
    EXPECT_NEAR(1000 * noise.axial_m(row.z_m), row.axial_mm, 0.05)
        << row.z_m;  // the table's digits
    EXPECT_NEAR(1000 * noise.lateral_m(row.z_m, 0, 575), row.lateral_mm, 0.006) << row.z_m;
  }
}

TEST(NoiseModel, GrowsWithIncidence) {
  const NoiseModel noise;
  EXPECT_GT(noise.axial_m(1, 1.2), noise.axial_m(1, 0.6));
  EXPECT_GT(noise.lateral_m(1, 1.2, 575), noise.lateral_m(1, 0.6, 575));
  // 0.0012 + 0.0019 0.36 + 0.0001 (at 45 degrees the angles' quotient is one).
  EXPECT_NEAR(noise.axial_m(1, 0.785398163), 0.001984, 1e-9);
}

TEST(NoiseModel, IsTheConstantWhereThatIsGiven) {
  const NoiseModel laser{.constant_m = 0.002};
  EXPECT_EQ(laser.axial_m(30, 1.5), 0.002);
  EXPECT_EQ(laser.lateral_m(30, 1.5, 575), 0.002);
}

}  // namespace
}  // namespace spool
