// The lists of a cut sheet.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/spool_lists.h"

#include <gtest/gtest.h>

#include "tests/vision/guide/small_spool.h"

namespace spool::test {
namespace {

TEST(SpoolLists, PipesAreSawnToCentresLessTakeOffsAndGaps) {
  const auto rows = guide::cut_rows(small_spool(), {guide::GapRule::kSubtract, 0.003});
  ASSERT_EQ(rows.size(), 4U);
  // pipe_1: flange 76, tee 105, two gaps.
  EXPECT_EQ(rows[0].piece, "pipe_1");
  EXPECT_NEAR(rows[0].centre_to_centre_m, 0.581, 1e-9);
  EXPECT_NEAR(rows[0].take_off_m, 0.181, 1e-9);
  EXPECT_NEAR(rows[0].cut_m, 0.394, 1e-9);
  EXPECT_NEAR(rows[3].gap_m, 0.003, 1e-9);  // its other end is open
}

TEST(SpoolLists, AlikeMaterialIsOneRow) {
  const auto rows = guide::material_rows(small_spool(), {});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].text, "pipe");
  EXPECT_EQ(rows[0].pieces, 4);
  EXPECT_NEAR(rows[0].length_m, 1.8, 1e-9);
  EXPECT_EQ(rows[1].text, "flange");
  EXPECT_EQ(rows[1].pieces, 2);
  EXPECT_EQ(rows[3].text, "elbow 90\u00b0");
  EXPECT_EQ(rows[3].nps, "4");
}

TEST(SpoolLists, WeldsSayTheirTurnInThePlan) {
  const DesignModel design = small_spool();
  const auto plan = guide::plan_roll_welds(design, {});
  const auto rows = guide::weld_rows(design, plan);
  ASSERT_EQ(rows.size(), 7U);
  for (const auto& row : rows) {
    const auto& planned = plan.order[static_cast<std::size_t>(row.turn - 1)];
    EXPECT_EQ(design.joints[static_cast<std::size_t>(planned.joint)].weld, row.number);
  }
  EXPECT_EQ(rows[0].between, "flange_1, pipe_1");
}

}  // namespace
}  // namespace spool::test
