// Tests of the trend lines and of where they cross: exact data, brute force, what must be doubted.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/k_curves.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

const std::vector<double> kKs = {1, 7, 10, 50, 110, 285};

TEST(KCurves, AreFoundAgainFromTheirOwnValues) {
  const LogCurve log{0.05, -0.02};
  const PowerCurve power{0.8, -1.1};
  std::vector<double> noise, lost;
  for (const double k : kKs) {
    noise.push_back(log.at(k));
    lost.push_back(power.at(k));
  }
  EXPECT_DOUBLE_EQ(power.at(1), 0.8);
  EXPECT_DOUBLE_EQ(log.at(1), -0.02);
  const LogCurve log_fit = fit_log_curve(kKs, noise);
  EXPECT_NEAR(log_fit.a, log.a, 1e-12);
  EXPECT_NEAR(log_fit.b, log.b, 1e-12);
  EXPECT_NEAR(log_fit.r_squared, 1, 1e-12);
  lost[3] = 0;  // nothing lost at one K: no logarithm, and the others say the same
  const PowerCurve power_fit = fit_power_curve(kKs, lost);
  EXPECT_NEAR(power_fit.a, power.a, 1e-12);
  EXPECT_NEAR(power_fit.b, power.b, 1e-12);
  EXPECT_NEAR(power_fit.r_squared, 1, 1e-12);
}

TEST(KCurves, TooFewKsMakeNoCurve) {
  const std::vector<double> two = {1, 2}, same = {5, 5, 5}, rates = {0.1, 0.2, 0.3};
  EXPECT_EQ(fit_log_curve(two, std::vector<double>{0.1, 0.2}).a, 0);
  EXPECT_EQ(fit_log_curve(same, rates).a, 0);
  EXPECT_EQ(fit_power_curve(kKs, std::vector<double>(6, 0.0)).a, 0);
  EXPECT_EQ(k_by_crossing(fit_log_curve(two, std::vector<double>{0.1, 0.2}), {0.8, -1}), 0);
}

TEST(KCrossing, IsWhereABruteForceSearchFindsTheCurvesEqual) {
  for (const double a : {0.01, 0.05, 0.3})
    for (const double b : {-0.3, -0.02, 0.05})
      for (const double a2 : {0.05, 0.8})
        for (const double b2 : {-2.0, -0.5, -0.1}) {
          const KCrossing found = cross({a, b}, {a2, b2});
          ASSERT_TRUE(found.exists);
          // The curves' distance, smallest over a fine ladder of K from e^-40 to e^40.
          double best = std::numeric_limits<double>::infinity(), at = 0;
          for (double x = -40; x <= 40; x += 1e-3) {
            const double apart = std::abs(a * x + b - a2 * std::exp(b2 * x));
            if (apart < best) {
              best = apart;
              at = x;
            }
          }
          EXPECT_NEAR(std::log(found.k), at, 1e-3);
          EXPECT_NEAR(LogCurve({a, b}).at(found.k), PowerCurve({a2, b2}).at(found.k),
                      1e-12 * (1 + std::abs(b)));
          EXPECT_NEAR(found.rate, PowerCurve({a2, b2}).at(found.k), 1e-9);
        }
}

TEST(KCrossing, StaysFiniteWhateverTheCoefficients) {
  for (const double a : {1e-12, 1.0, 1e12})
    for (const double b : {-1e9, 0.0, 1e9})
      for (const double a2 : {1e-12, 1.0, 1e12})
        for (const double b2 : {-1e3, -1.0, -1e-3}) {
          const KCrossing found = cross({a, b}, {a2, b2});
          EXPECT_TRUE(found.exists ? std::isfinite(found.k) && found.k > 0 : !found.doubt.empty());
        }
}

TEST(KCrossing, SaysWhatItDoubts) {
  EXPECT_NE(cross({0.05, 0}, {0.8, 1}).doubt.find("has to rise"), std::string::npos);
  EXPECT_NE(cross({-0.05, 0}, {0.8, -1}).doubt.find("has to rise"), std::string::npos);
  EXPECT_FALSE(cross({NAN, 0}, {0.8, -1}).exists);
  // Crossing where the void rate is negative: exists, but not as a K to use.
  const KCrossing negative = cross({0.3, -0.25}, {-0.02, 0.13});
  EXPECT_TRUE(negative.exists);
  EXPECT_NE(negative.doubt.find("negative"), std::string::npos);
  EXPECT_EQ(k_by_crossing({0.3, -0.25}, {-0.02, 0.13}), 0);
  EXPECT_NE(cross({2, 3}, {5, -0.1}).doubt.find("as much is lost as there is"), std::string::npos);
  // Before K = 1: one neighbour is the least.
  EXPECT_EQ(k_by_crossing({0.1, 0.4}, {0.3, -1}), 1);
  // 0.05 ln 9 - 0.02 = 0.0899, 0.8 / 9 = 0.0889.
  EXPECT_EQ(k_by_crossing({0.05, -0.02}, {0.8, -1}), 9);
}

}  // namespace
}  // namespace spool
