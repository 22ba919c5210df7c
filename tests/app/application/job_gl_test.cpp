// A job's step on the screen: the ghost of what comes next, a check into the journal, Accept.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/job/job_progress.h"
#include "tests/app/application/job_bench.h"

namespace spool {
namespace {

using job::Outcome;
using test::JobOnScreen;

TEST_F(JobOnScreen, ShowsTheNextPartsGhostUntilItIsAccepted) {
  ASSERT_NO_FATAL_FAILURE(open(2));
  EXPECT_EQ(screen_["step"], "step 3 of 3");
  ASSERT_NO_FATAL_FAILURE(align());
  EXPECT_NE(std::string(screen_["hint"]).find("W2, fab weld"), std::string::npos)
      << screen_["hint"];
  const int with_ghost = blue();
  EXPECT_GT(with_ghost, 300);
  EXPECT_FALSE(offers("Accept")) << "it was not checked";
  press("Check");
  for (int i = 0; i < 6 && !offers("Accept"); ++i) step();
  ASSERT_TRUE(offers("Accept")) << screen_.dump();
  EXPECT_EQ(journal().size(), 3U) << "the check is in the journal before anybody decides";
  press("Accept");
  EXPECT_EQ(screen_["step"], "all 3 steps accepted");
  EXPECT_FALSE(offers("Accept"));
  EXPECT_LT(blue() + 500, with_ghost) << "buttons are blue as well, before and after";
  const std::vector<job::CheckRecord> records = journal();
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[2].outcome, Outcome::kRedo);
  EXPECT_EQ(records[3].outcome, Outcome::kAccept);
  EXPECT_EQ(records[3].report_sha256, records[2].report_sha256);
  EXPECT_FALSE(records[3].report_sha256.empty());
  EXPECT_EQ(records[3].operator_name, "operator 1");
  const auto histories = job::joint_histories(records);
  ASSERT_EQ(histories.size(), 2U);
  EXPECT_EQ(histories[1].tries, 1) << "one check, decided";
}

// What is not on the table is neither drawn nor proposed nor picked.
TEST_F(JobOnScreen, LeavesOutWhatIsNotBuiltYet) {
  ASSERT_NO_FATAL_FAILURE(open(0));
  EXPECT_EQ(screen_["step"], "step 1 of 3");
  EXPECT_EQ(std::string(screen_["hint"]).find("arm"), std::string::npos) << screen_["hint"];
  EXPECT_EQ(std::string(screen_["hint"]).find("post"), std::string::npos) << screen_["hint"];
  const auto pairs = three();
  int refused = 0;
  for (const test::SpotPair& pair : pairs) {
    tap_at(pair.design);
    const std::string hint = screen_["hint"];
    EXPECT_EQ(hint.find("arm,"), std::string::npos) << hint;
    EXPECT_EQ(hint.find("post,"), std::string::npos) << hint;
    if (hint.find("where you tapped") == std::string::npos)
      ++refused;
    else
      press("Undo");  // what was chosen stays so, whatever is tapped next
  }
  EXPECT_GT(refused, 0) << "the three points lie on more than the base";
}

TEST_F(JobOnScreen, IsHeldAlone) {
  ASSERT_NO_FATAL_FAILURE(open(0));
  const auto second = JobSession::open(path_, "");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace spool
