// Claims about what a state tells of the design's surface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/coverage.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/vision/live/placed_states.h"

namespace spool {
namespace {

TEST(Coverage, AsksForTheDatumUntilItWasSeen) {
  DesignModel model = test::bracket_design();
  model.datums = {0};
  const auto design = PreparedDesign::prepare(std::move(model));
  ASSERT_TRUE(design.has_value());
  Coverage coverage(*design, test::small_camera(), test::small_camera(), test::millimetre_noise());
  const auto tell = [&](int i, bool with_readings) {
    VisionState state = test::placed_state(test::walking(i), test::walking(i), i);
    if (with_readings) coverage.add(state, Matrix6d::Zero());
    coverage.tell(state, Matrix6d::Zero());
    return state.coverage;
  };
  EXPECT_EQ(tell(0, false).advice.text, "Look at base too: all is measured from it.");
  const CoverageState seen = tell(1, true);
  EXPECT_EQ(seen.advice.text, "");
  EXPECT_TRUE(seen.parts[0].is_seen);
  // What is known of patches and of the part they are of agrees.
  ASSERT_EQ(seen.sight.size(), seen.patches->all().size());
  EXPECT_GT(std::ranges::count(seen.sight, PatchSight::kKnown) +
                std::ranges::count(seen.sight, PatchSight::kPartly),
            50);
  coverage.clear();
  const CoverageState anew = tell(2, false);
  EXPECT_FALSE(anew.parts[0].is_seen);
  EXPECT_EQ(std::ranges::count(anew.sight, PatchSight::kNotSeen),
            static_cast<long>(anew.sight.size()));
}

}  // namespace
}  // namespace spool
