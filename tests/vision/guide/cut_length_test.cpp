// Cut lengths of a design: by hand, and the same as the piping file's own cut list.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/cut_length.h"

#include <map>

#include <gtest/gtest.h>

#include "tests/vision/guide/small_spool.h"
#include "tests/vision/piping/pcf_samples.h"
#include "vision/design/pipework_design.h"
#include "vision/piping/cut_list.h"
#include "vision/piping/pcf_reader.h"

namespace spool::test {
namespace {

using guide::cut_length;
using guide::GapRule;
using guide::joint_ends;

constexpr double kExact_m = 1e-9;  // sums of a few lengths in double

TEST(CutLength, IsTheDrawnLengthLessTheGapsOfThePolicy) {
  const DesignModel design = small_spool();
  const int pipe = part_named(design, "pipe_1");
  const auto cut = cut_length(design, joint_ends(design), pipe, {GapRule::kSubtract, 0.003});
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->drawn_m, 0.4, kExact_m);
  EXPECT_NEAR(cut->cut_m(), 0.394, kExact_m);                             // two welds
  EXPECT_NEAR(cut->centre_to_centre_m(), 0.4 + 0.076 + 0.105, kExact_m);  // flange and half a tee
  for (const GapRule rule : {GapRule::kNone, GapRule::kModelHasGaps})
    EXPECT_NEAR(cut_length(design, joint_ends(design), pipe, {rule, 0.003})->cut_m(), 0.4,
                kExact_m);
}

TEST(CutLength, OfAnOpenEndTakesNoGapThere) {
  const DesignModel design = small_spool();
  const auto cut = cut_length(design, joint_ends(design), part_named(design, "pipe_4"),
                              {GapRule::kSubtract, 0.003});
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->cut_m(), 0.197, kExact_m);
  EXPECT_NEAR(cut->ends[0].take_off_m, 0.152, kExact_m);  // the elbow, to where its axes meet
  EXPECT_EQ(cut->ends[1].neighbour, -1);
}

TEST(CutLength, OfTwoPipesThatMeetTakesHalfTheGapOffEach) {
  DesignModel design = small_spool();
  Part further = design.parts[static_cast<std::size_t>(part_named(design, "pipe_4"))];
  further.name = "pipe_5";
  further.T_design_part.translation().x() += 0.2;
  design.parts.push_back(further);
  const int pipe_4 = part_named(design, "pipe_4"), pipe_5 = part_named(design, "pipe_5");
  design.joints.push_back({"W8", pipe_4, 1, pipe_5, 0, JointType::kFab});
  const auto ends = joint_ends(design);
  EXPECT_NEAR(cut_length(design, ends, pipe_4, {GapRule::kSubtract, 0.003})->cut_m(), 0.1955,
              kExact_m);
  EXPECT_NEAR(cut_length(design, ends, pipe_5, {GapRule::kSubtract, 0.003})->cut_m(), 0.1985,
              kExact_m);
}

TEST(CutLength, OfAFittingThereIsNone) {
  const DesignModel design = small_spool();
  EXPECT_FALSE(cut_length(design, joint_ends(design), part_named(design, "tee_1"), {}));
}

// The piping file's list comes from its records, ours from ports and joints alone.
TEST(CutLength, AgreesWithThePipingFilesCutList) {
  const auto pipework = piping::read_pcf(spool_pcf(), "spool.pcf");
  ASSERT_TRUE(pipework);
  DesignModel design;
  design.path = "spool.pcf";
  ASSERT_TRUE(design_of(*pipework, design));
  const auto names = part_names(*pipework);
  const auto ends = joint_ends(design);
  int compared = 0;
  for (const piping::CutPipe& listed : piping::cut_list(*pipework, 0.003)) {
    const int part = part_named(design, names[static_cast<std::size_t>(listed.component)]);
    const auto cut = cut_length(design, ends, part, {GapRule::kSubtract, 0.003});
    ASSERT_TRUE(cut);
    EXPECT_NEAR(cut->cut_m(), listed.cut(), 1e-6)
        << names[static_cast<std::size_t>(listed.component)];
    EXPECT_NEAR(cut->centre_to_centre_m(), listed.centre_to_centre(), 1e-6)
        << names[static_cast<std::size_t>(listed.component)];
    ++compared;
  }
  EXPECT_GE(compared, 4);
}

}  // namespace
}  // namespace spool::test
