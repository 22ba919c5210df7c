// Tests of the sensor's scale by known sizes: drawn from the mills' tolerances, many seeds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/gauge_check.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace spool {
namespace {

constexpr double kCalibrated = 0.0005;
constexpr double kMill = 0.0008, kRim = 0.0016;  // m, half widths: ASTM A999, ASME B16.5

// Two flanges and three pipes of NPS 4 at 0.7 to 1.5 m: true sizes anywhere within tolerance (as
// rectangles), read by a sensor whose metre reads s(z) metres with 0.3 mm of noise.
std::vector<Gauge> gauges_of(std::mt19937& random, const std::function<double(double)>& s,
                             bool has_range = true) {
  constexpr double kNoise = 0.0003;
  std::uniform_real_distribution<double> within(-1, 1);
  std::normal_distribution<double> normal;
  std::vector<Gauge> gauges;
  for (int part = 0; part < 5; ++part) {
    const bool is_flange = part < 2;
    const double nominal = is_flange ? 0.2286 : 0.1143, half = is_flange ? kRim : kMill;
    const double range = 0.7 + 0.2 * part;
    Gauge gauge{
        .kind = is_flange ? GaugeKind::kFlangeDiameter : GaugeKind::kPipeDiameter,
        .part = part,
        .nominal_m = nominal,
        .tolerance_u_m = half / std::sqrt(3.0),
        .measured_m = s(range) * (nominal + half * within(random)) + kNoise * normal(random),
        .u_m = kNoise};
    if (has_range) gauge.range_m = range;
    gauges.push_back(gauge);
  }
  return gauges;
}

double share_contradicted(const std::function<double(double)>& s, double scale_u, int seeds = 2000,
                          bool has_range = true) {
  int count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    const auto check = check_scale(gauges_of(random, s, has_range), {.scale_u = scale_u});
    count += check->is_contradicted ? 1 : 0;
  }
  return static_cast<double>(count) / seeds;
}

TEST(GaugeCheck, ContradictsACalibrationThatDeniesOnePercentInNineteenOfTwenty) {
  for (const double error : {0.01, -0.01})
    for (const bool has_range : {true, false})
      EXPECT_GE(share_contradicted([&](double) { return 1 + error; }, kCalibrated, 2000, has_range),
                0.95)
          << error << (has_range ? "" : " without ranges");
}

TEST(GaugeCheck, ContradictsAnHonestCalibrationNoOftenerThanItSays) {
  constexpr int kSeeds = 2000;
  for (const double scale_u : {kCalibrated, 0.005}) {
    int count = 0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      std::mt19937 random(static_cast<std::uint32_t>(seed));
      const double error = scale_u * std::normal_distribution<double>()(random);
      const auto check =
          check_scale(gauges_of(random, [&](double) { return 1 + error; }), {.scale_u = scale_u});
      count += check->is_contradicted ? 1 : 0;
    }
    // 0.01 and five standard errors of a share of so many seeds.
    EXPECT_LE(count, (0.01 + 0.011) * kSeeds) << scale_u;
  }
}

TEST(GaugeCheck, ToleratesOnePercentOfASensorThatWasNeverCalibrated) {
  EXPECT_LE(share_contradicted([](double) { return 1.01; }, 0.005), 0.05);
}

// The narrowed scale covers the truth as often as it says, corrected or not.
TEST(GaugeCheck, NarrowsAnUncalibratedScaleHonestly) {
  constexpr int kSeeds = 2000;
  int within = 0, corrected = 0;
  double sum = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    std::normal_distribution<double> normal;
    const double error = 0.005 * normal(random);
    const auto check = check_scale(gauges_of(
                                       random, [&](double) { return 1 + error; }, false),
                                   {.scale_u = 0.005});
    within += std::abs(error - check->correction) < 2 * check->scale_u ? 1 : 0;
    corrected += check->correction != 0 ? 1 : 0;
    sum += check->scale_u;
  }
  EXPECT_GT(within, 0.94 * kSeeds);
  EXPECT_LT(sum / kSeeds, 0.0045);
  EXPECT_GT(corrected, 0.2 * kSeeds);
}

TEST(GaugeCheck, FindsAScaleThatGrowsWithRange) {
  Gauge bar{.kind = GaugeKind::kScaleBar, .nominal_m = 1, .u_m = 0.0001};
  std::vector<Gauge> bars;
  for (const double range : {0.6, 1.0, 1.4, 2.0}) {
    bar.part = static_cast<int>(bars.size());
    bar.range_m = range;
    bar.measured_m = 1.002 + 0.003 * range;
    bars.push_back(bar);
  }
  const auto check = check_scale(bars, {.scale_u = 0.005});
  ASSERT_TRUE(check);
  // The prior draws by (1e-4 / 0.005)^2 at most.
  EXPECT_NEAR(check->a, 0.002, 2e-5);
  EXPECT_NEAR(check->b_per_m, 0.003, 2e-5);
  EXPECT_FALSE(check->is_contradicted);
  const auto denied = check_scale(bars, {.scale_u = 0.0002});
  EXPECT_TRUE(denied->is_contradicted);
  // The length left alone is off by as much at the farthest bar.
  EXPECT_GT(denied->scale_u, 0.0079);
  EXPECT_EQ(denied->correction, 0);
}

TEST(GaugeCheck, LeavesACalibratedScaleAlone) {
  std::mt19937 random(3);
  const auto check = check_scale(gauges_of(random, [](double) { return 1.0; }), {.scale_u = 0});
  EXPECT_EQ(check->scale_u, 0);
  EXPECT_EQ(check->a, 0);
}

TEST(GaugeCheck, TakesAPieceOfAnotherSizeForNoGauge) {
  Gauge pipe{
      .part = 1, .nominal_m = 0.1143, .tolerance_u_m = 0.0005, .measured_m = 0.1683, .u_m = 0.0005};
  EXPECT_FALSE(check_scale(std::vector{pipe}));
  pipe.measured_m = std::nan("");
  EXPECT_FALSE(check_scale(std::vector{pipe}));
  EXPECT_FALSE(check_scale({}));
}

TEST(GaugeCheck, AccusesNoSensorForOnePartAlone) {
  const Gauge pipe{
      .part = 1, .nominal_m = 0.3239, .tolerance_u_m = 0.0005, .measured_m = 0.332, .u_m = 0.0003};
  const auto check = check_scale(std::vector{pipe, pipe}, {.scale_u = kCalibrated});
  EXPECT_GT(check->statistic, check->limit);
  EXPECT_FALSE(check->is_contradicted);
  // One pipe of five that is of another make scatters, and is not taken for a scale.
  std::mt19937 random(5);
  auto gauges = gauges_of(random, [](double) { return 1.0; });
  gauges.back().measured_m *= 1.035;
  EXPECT_FALSE(check_scale(gauges, {.scale_u = kCalibrated})->is_contradicted);
}

}  // namespace
}  // namespace spool
