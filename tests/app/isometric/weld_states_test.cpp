// How far a weld is by the checks of its step.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/weld_states.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using isometric::WeldStage;
using job::Outcome;
using job::Phase;

job::CheckRecord check(const char* joint, Phase phase, Outcome outcome, const char* by = "A. B.") {
  job::CheckRecord record;
  record.joint = joint;
  record.phase = phase;
  record.outcome = outcome;
  record.operator_name = by;
  record.at.wall_s = 1764403200;  // 2025-11-29 08:00 UTC
  return record;
}

struct Case {
  const char* name;
  std::vector<job::CheckRecord> records;
  WeldStage stage;
  const char* signed_by;
};

TEST(WeldStates, FollowTheLastChecks) {
  const Case cases[] = {
      {"fitted up only", {check("W1", Phase::kBeforeTack, Outcome::kAccept)}, WeldStage::kToDo, ""},
      {"tacked, to be redone",
       {check("W1", Phase::kAfterTack, Outcome::kRedo)},
       WeldStage::kTacked,
       ""},
      {"tacked and accepted",
       {check("W1", Phase::kAfterTack, Outcome::kAccept)},
       WeldStage::kChecked,
       "A. B."},
      {"accepted with a remark",
       {check("W1", Phase::kBeforeWeld, Outcome::kRemark)},
       WeldStage::kChecked,
       "A. B."},
      {"a redo takes the signature back",
       {check("W1", Phase::kAfterTack, Outcome::kAccept),
        check("W1", Phase::kBeforeWeld, Outcome::kRedo)},
       WeldStage::kTacked,
       ""},
      {"welded, not accepted",
       {check("W1", Phase::kAfterTack, Outcome::kAccept, "C. D."),
        check("W1", Phase::kAfterWeld, Outcome::kRedo)},
       WeldStage::kWelded,
       "C. D."},
      {"welded and accepted",
       {check("W1", Phase::kAfterWeld, Outcome::kAccept)},
       WeldStage::kAccepted,
       ""}};
  for (const Case& each : cases) {
    const auto states = isometric::weld_states(each.records);
    ASSERT_EQ(states.size(), 1U) << each.name;
    EXPECT_EQ(states[0].stage, each.stage) << each.name;
    EXPECT_EQ(states[0].fit_up_by, each.signed_by) << each.name;
    EXPECT_EQ(states[0].fit_up_on, each.signed_by[0] == '\0' ? "" : "2025-11-29") << each.name;
  }
}

TEST(WeldStates, AStepOfTwoWeldsIsBoth) {
  const auto states = isometric::weld_states({check("", Phase::kAfterTack, Outcome::kAccept),
                                              check("W5+W6", Phase::kAfterTack, Outcome::kAccept)});
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].weld, "W5");
  EXPECT_EQ(states[1].weld, "W6");
}

}  // namespace
}  // namespace spool::test
