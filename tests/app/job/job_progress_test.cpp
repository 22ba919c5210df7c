// Accepted steps, tries, time and shrinkage off records, with clocks that jump.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/job_progress.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using job::CheckRecord;
using job::Outcome;
using job::Phase;

std::vector<CheckRecord> numbered(std::vector<CheckRecord> records) {
  std::int64_t id = 0;
  for (CheckRecord& each : records) each.id = ++id;
  return records;
}

CheckRecord check(const char* part, const char* joint, Phase phase, Outcome outcome, double boot_s,
                  double wall_s, const char* boot = "b1") {
  CheckRecord record;
  record.part = part;
  record.joint = joint;
  record.phase = phase;
  record.outcome = outcome;
  record.at = {wall_s, boot_s, boot};
  return record;
}

TEST(JobProgress, TheLastOutcomeOfAPartDecides) {
  const std::vector<std::string> order{"a", "b", "c"};
  auto records = numbered({check("a", "", Phase::kAfterTack, Outcome::kAccept, 1, 1),
                           check("b", "W1", Phase::kAfterTack, Outcome::kRedo, 2, 2)});
  EXPECT_EQ(current_step(order, records), 1);
  records.push_back(check("b", "W1", Phase::kAfterTack, Outcome::kRemark, 3, 3));
  EXPECT_EQ(current_step(order, records), 2);
  records.push_back(check("a", "", Phase::kAfterWeld, Outcome::kRedo, 4, 4));
  EXPECT_EQ(current_step(order, records), 0);
  EXPECT_EQ(accepted_record("a", records), nullptr);
  EXPECT_EQ(accepted_record("b", records), &records[2]);
  EXPECT_EQ(current_step({}, records), 0);
}

TEST(JobProgress, CountsTriesToTheFirstAcceptance) {
  const auto histories =
      joint_histories(numbered({check("b", "W1", Phase::kBeforeTack, Outcome::kRedo, 10, 100),
                                check("b", "W1", Phase::kAfterTack, Outcome::kRedo, 40, 130),
                                check("c", "W2", Phase::kAfterTack, Outcome::kAccept, 50, 140),
                                check("b", "W1", Phase::kAfterTack, Outcome::kAccept, 70, 160),
                                check("b", "W1", Phase::kAfterWeld, Outcome::kAccept, 100, 190)}));
  ASSERT_EQ(histories.size(), 2u);
  EXPECT_EQ(histories[0].joint, "W1");
  EXPECT_EQ(histories[0].tries, 3);
  EXPECT_EQ(histories[0].checks, 4);
  EXPECT_DOUBLE_EQ(histories[0].seconds, 90);
  EXPECT_TRUE(histories[0].is_accepted);
  EXPECT_EQ(histories[1].tries, 1);
}

TEST(JobProgress, AClockThatIsSetBackChangesNeitherOrderNorTime) {
  // The wall's clock goes back by a day between the checks, and forward by a year after them.
  const auto histories = joint_histories(
      numbered({check("b", "W1", Phase::kAfterTack, Outcome::kRedo, 10, 1e9),
                check("b", "W1", Phase::kAfterTack, Outcome::kAccept, 40, 1e9 - 86400),
                check("b", "W1", Phase::kAfterWeld, Outcome::kAccept, 60, 2e9)}));
  EXPECT_DOUBLE_EQ(histories[0].seconds, 50);
  EXPECT_TRUE(histories[0].time_is_whole);
  EXPECT_TRUE(histories[0].is_accepted);
}

TEST(JobProgress, OverAReStartTheWallTellsTheTimeWhereItCan) {
  auto records = numbered({check("b", "W1", Phase::kAfterTack, Outcome::kRedo, 900, 1000, "b1"),
                           check("b", "W1", Phase::kAfterTack, Outcome::kAccept, 20, 1060, "b2")});
  EXPECT_DOUBLE_EQ(joint_histories(records)[0].seconds, 60);
  records[1].at.wall_s = 500;  // and where that went back as well, nobody knows
  EXPECT_DOUBLE_EQ(joint_histories(records)[0].seconds, 0);
  EXPECT_FALSE(joint_histories(records)[0].time_is_whole);
}

TEST(JobProgress, ShrinkageIsAfterTheWeldLessBefore) {
  auto records = numbered({check("b", "W1", Phase::kAfterTack, Outcome::kAccept, 1, 1),
                           check("b", "W1", Phase::kBeforeWeld, Outcome::kAccept, 2, 2),
                           check("b", "W1", Phase::kAfterWeld, Outcome::kAccept, 3, 3)});
  records[0].numbers = {{"length", "", "m", 0.5, 0.510, 0.010, 0.0003}};
  records[1].numbers = {{"length", "", "m", 0.5, 0.502, 0.002, 0.0003},
                        {"angle", "", "rad", 0.0, std::nullopt}};
  records[2].numbers = {{"angle", "", "rad", 0.0, 0.01},
                        {"length", "", "m", 0.5, 0.5005, 0.0005, 0.0004}};
  auto shrinkage = joint_histories(records)[0].shrinkage;
  ASSERT_EQ(shrinkage.size(), 1u) << "the angle was not measured before";
  EXPECT_EQ(shrinkage[0].number, "length");
  EXPECT_NEAR(shrinkage[0].change, -0.0015, 1e-12);
  EXPECT_NEAR(shrinkage[0].u, 0.0005, 1e-12);
  records.erase(records.begin() + 1);  // without a check before the weld that after the tack counts
  EXPECT_NEAR(joint_histories(records)[0].shrinkage.at(0).change, -0.0095, 1e-12);
}

TEST(JobProgress, TimesReadAsUtc) {
  EXPECT_EQ(job::utc_text(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(job::utc_text(1795932900.25), "2026-11-29T06:15:00.250Z");
  EXPECT_EQ(job::utc_text(-1), "-");
  EXPECT_EQ(job::utc_text(1e300), "-");
}

}  // namespace
}  // namespace spool::test
