// Claims about numbers that stand still until they changed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/steady_readings.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

PartReading reading(double mean_m, double u_m) { return {true, mean_m, u_m, 0.5}; }

TEST(SteadyReadings, StepOnlyByMoreThanTheirUncertainty) {
  SteadyReadings steady;
  steady.follow({reading(0.0040, 0.0010), reading(0, 0.001)}, false);
  steady.follow({reading(0.0049, 0.0010), reading(0, 0.001)}, false);
  EXPECT_EQ(steady.held()[0].mean_m, 0.0040);
  steady.follow({reading(0.0051, 0.0010), reading(0, 0.001)}, false);
  EXPECT_EQ(steady.held()[0].mean_m, 0.0051);
  EXPECT_EQ(steady.held()[1].mean_m, 0);
}

TEST(SteadyReadings, StandStillUnderNoiseAndAreNeverFurtherOffThanTheirDoubt) {
  SteadyReadings steady;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.0002);  // u_m is 2.5 of these
  int steps = 0;
  double last = 0;
  for (int i = 0; i < 900; ++i) {  // half a minute
    const PartReading now = reading(0.003 + noise(random), 0.0005);
    steady.follow({now}, false);
    const double held = steady.held()[0].mean_m;
    steps += i > 0 && held != last ? 1 : 0;
    last = held;
    EXPECT_LE(std::abs(held - now.mean_m), now.u_m);
  }
  EXPECT_LT(steps, 90) << "thirty times a second they would step 899 times";
}

TEST(SteadyReadings, SayADoubtThatGrowsAtOnceAndOneThatHalves) {
  SteadyReadings steady;
  steady.follow({reading(0.004, 0.0010)}, false);
  steady.follow({reading(0.004, 0.0009)}, false);
  EXPECT_EQ(steady.held()[0].u_m, 0.0010);
  steady.follow({reading(0.004, 0.0011)}, false);
  EXPECT_EQ(steady.held()[0].u_m, 0.0011);
  steady.follow({reading(0.004, 0.0005)}, false);
  EXPECT_EQ(steady.held()[0].u_m, 0.0005);
}

TEST(SteadyReadings, BeginAfresh) {
  SteadyReadings steady;
  steady.follow({reading(0.0040, 0.0010)}, false);
  steady.follow({reading(0.0042, 0.0010)}, true);
  EXPECT_EQ(steady.held()[0].mean_m, 0.0042);
  steady.follow({{}}, false);
  EXPECT_FALSE(steady.held()[0].is_seen) << "out of sight is said at once";
  steady.follow({reading(0.0041, 0.0010)}, false);
  EXPECT_EQ(steady.held()[0].mean_m, 0.0041);
}

TEST(HasMoved, IsSaidWhereTheDoubtsDoNotMeet) {
  const std::vector<PartReading> before{reading(0.001, 0.001), reading(0.002, 0.0005)};
  EXPECT_FALSE(has_moved(before, before));
  EXPECT_FALSE(has_moved(before, {reading(0.0025, 0.0006), reading(0.002, 0.0005)}));
  EXPECT_TRUE(has_moved(before, {reading(0.001, 0.001), reading(-0.004, 0.0005)}));
  EXPECT_FALSE(has_moved(before, {{}, {}})) << "what is out of sight was not seen to move";
}

}  // namespace
}  // namespace spool
