// The colours of deviations, held against colour science that the code does not use.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/deviation_colour.h"

#include <cmath>

#include <gtest/gtest.h>

namespace spool::render {
namespace {

constexpr double kNeutral = 0.001;
constexpr double kRange = 0.010;

Eigen::Vector3f linear(const Eigen::Vector3f& srgb) {
  return srgb.unaryExpr(
      [](float x) { return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F); });
}

// CIE 1976 L*a*b*, D65, from IEC 61966-2-1's primaries.
Eigen::Vector3f lab(const Eigen::Vector3f& linear_rgb) {
  Eigen::Matrix3f to_xyz;
  to_xyz << 0.4124F, 0.3576F, 0.1805F, 0.2126F, 0.7152F, 0.0722F, 0.0193F, 0.1192F, 0.9505F;
  const Eigen::Vector3f xyz =
      (to_xyz * linear_rgb).cwiseQuotient(Eigen::Vector3f(0.9505F, 1.0F, 1.089F));
  const Eigen::Vector3f f = xyz.unaryExpr(
      [](float t) { return t > 0.008856F ? std::cbrt(t) : 7.787F * t + 16.0F / 116.0F; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

float lightness(double deviation_m) {
  return lab(linear(deviation_colour(deviation_m, kNeutral, kRange))).x();
}

TEST(DeviationColour, IsEquallyLightOnBothSides) {
  for (double d = 0; d <= 0.012; d += 0.0005) {
    // 1.5 of 100 is about the smallest difference of lightness that is seen side by side.
    EXPECT_NEAR(lightness(d), lightness(-d), 1.5) << d;
  }
}

TEST(DeviationColour, DarkensEvenlyFromTheNeutralBandOutwards) {
  float before = lightness(kNeutral);
  for (double d = 0.002; d < 0.0101; d += 0.001) {
    const float here = lightness(d);
    EXPECT_NEAR(before - here, 34.0 / 9, 1.0) << d;  // 84 to 50 over nine millimetres
    before = here;
  }
}

TEST(DeviationColour, IsGreyWithinTheNeutralBandAndContinuousAtItsEnd) {
  const Eigen::Vector3f grey = deviation_colour(0, kNeutral, kRange);
  EXPECT_FLOAT_EQ(grey.minCoeff(), grey.maxCoeff());
  for (const double d : {-0.001, -0.0005, 0.0009, 0.001}) {
    EXPECT_EQ(deviation_colour(d, kNeutral, kRange), grey) << d;
  }
  for (const double d : {-0.00101, 0.00101}) {
    EXPECT_LT((deviation_colour(d, kNeutral, kRange) - grey).norm(), 0.01F);
  }
}

TEST(DeviationColour, KeepsTheLastColourBeyondTheRange) {
  EXPECT_EQ(deviation_colour(0.5, kNeutral, kRange), outside_stops().back());
  EXPECT_EQ(deviation_colour(-0.5, kNeutral, kRange), inside_stops().back());
}

TEST(DeviationColour, PaintsInsideBlueAndOutsideRed) {
  const Eigen::Vector3f inside = deviation_colour(-0.005, kNeutral, kRange);
  const Eigen::Vector3f outside = deviation_colour(0.005, kNeutral, kRange);
  EXPECT_GT(inside.z(), inside.x() + 0.3F);
  EXPECT_GT(outside.x(), outside.z() + 0.3F);
}

// Full dichromacy as Vienot, Brettel and Mollon 1999 (protan, deutan) and Machado et al. 2009
// (tritan) simulate it, on linear RGB.
TEST(DeviationColour, SignsStayApartForTheColourBlind) {
  Eigen::Matrix3f protan;
  Eigen::Matrix3f deutan;
  Eigen::Matrix3f tritan;
  protan << 0.11238F, 0.88762F, 0, 0.11238F, 0.88762F, 0, 0.00401F, -0.00401F, 1;
  deutan << 0.29275F, 0.70725F, 0, 0.29275F, 0.70725F, 0, -0.02234F, 0.02234F, 1;
  tritan << 1.255528F, -0.076749F, -0.178779F, -0.078411F, 0.930809F, 0.147602F, 0.004733F,
      0.691367F, 0.303900F;
  for (const Eigen::Matrix3f& eye : {protan, deutan, tritan}) {
    const auto seen = [&](double d) {
      const Eigen::Vector3f rgb = eye * linear(deviation_colour(d, kNeutral, kRange));
      return lab(rgb.cwiseMax(0).cwiseMin(1));
    };
    // 10 units of CIE 1976 colour difference are told apart at a glance.
    for (const double d : {0.003, 0.005, 0.010}) {
      EXPECT_GT((seen(d) - seen(-d)).norm(), 20.0F) << d;
      EXPECT_GT((seen(d) - seen(0)).norm(), 8.0F) << d;
      EXPECT_GT((seen(-d) - seen(0)).norm(), 8.0F) << d;
    }
  }
}

}  // namespace
}  // namespace spool::render
