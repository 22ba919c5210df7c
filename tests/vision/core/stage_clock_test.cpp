// Laws of the stage clock: stages add up, and none is left out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/stage_clock.h"

#include <gtest/gtest.h>

namespace spool {
namespace {

TEST(StageClock, GivesEveryStageItsShareOfTheTotal) {
  std::map<std::string, double> timing_s;
  StageClock clock(timing_s);
  EXPECT_EQ(clock.total_s(), 0);
  clock.mark("first");
  clock.mark("second");
  ASSERT_EQ(timing_s.size(), 2U);
  EXPECT_GE(timing_s["first"], 0);
  EXPECT_GE(timing_s["second"], 0);
  // Seconds since the start are counted in nanoseconds and then divided: off by rounding alone.
  EXPECT_NEAR(timing_s["first"] + timing_s["second"], clock.total_s(), 1e-12);
}

TEST(StageClock, AddsToWhatAStageTookBefore) {
  std::map<std::string, double> timing_s = {{"track", 5.0}, {"thin", 1.0}};
  StageClock clock(timing_s);
  clock.mark("track");
  clock.mark("track");
  EXPECT_NEAR(timing_s["track"] - 5.0, clock.total_s(), 1e-12);
  EXPECT_GE(timing_s["track"], 5.0);
  EXPECT_EQ(timing_s["thin"], 1.0);  // a stage that was not marked keeps its seconds
}

}  // namespace
}  // namespace spool
