// A job's charts: which tries, of which number, and that they are on the pages.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/job_charts.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace spool::test {
namespace {

using isometric::JobCharts;
using isometric::JointChart;
using job::CheckNumber;
using job::CheckRecord;
using job::Outcome;

CheckNumber length(const std::string& name, std::optional<double> deviation_m,
                   double u_m = 0.0005) {
  CheckNumber number;
  number.name = name;
  number.unit = "m";
  number.deviation = deviation_m;
  number.tolerance = 0.003;
  number.u = u_m;
  return number;
}

CheckRecord check(const std::string& joint, Outcome outcome, double at_s,
                  std::vector<CheckNumber> numbers, const std::string& report = "") {
  CheckRecord record;
  record.joint = joint;
  record.part = "part of " + joint;
  record.outcome = outcome;
  record.at = {at_s, at_s, "b1"};
  record.numbers = std::move(numbers);
  record.report_sha256 = report;
  return record;
}

// Pixels of ink (darker than half) in a part of a page drawn with a pixel a millimetre times 4.
int ink(const JobCharts& charts, std::size_t page, int x0, int y0, int x1, int y1) {
  const auto pages = isometric::chart_pages(charts);
  const auto image = isometric::draw_page(pages.at(page), 4 * 25.4);
  EXPECT_TRUE(image);
  int count = 0;
  for (int y = 4 * y0; y < 4 * y1; ++y)
    for (int x = 4 * x0; x < 4 * x1; ++x) count += image->pixel(x, y)[0] < 128 ? 1 : 0;
  return count;
}

TEST(JobCharts, TriesAreOfTheNumberThatWasFurthestOut) {
  const auto charts = isometric::joint_charts(
      {{"W1", "elbow"}, {"W2", "flange"}},
      {check("W1", Outcome::kRedo, 0, {length("a", 0.001), length("b", -0.006)}),
       check("W1", Outcome::kAccept, 60, {length("a", 0.002), length("b", 0.0015)})});
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].number, "b");
  ASSERT_EQ(charts[0].tries.size(), 2u);
  EXPECT_NEAR(*charts[0].tries[0].deviation, -2, 1e-12);
  EXPECT_NEAR(*charts[0].tries[1].deviation, 0.5, 1e-12);
  EXPECT_NEAR(charts[0].tries[0].u, 2 * 0.0005 / 0.003, 1e-12);
  EXPECT_EQ(charts[0].history.tries, 2);
  EXPECT_DOUBLE_EQ(charts[0].history.seconds, 60);
  EXPECT_TRUE(charts[1].tries.empty());
  EXPECT_TRUE(charts[1].number.empty());
}

TEST(JobCharts, TwoDecisionsOnOneReportAreOneTry) {
  const auto charts = isometric::joint_charts(
      {{"W1", "elbow"}}, {check("W1", Outcome::kRedo, 0, {length("a", 0.002)}, "r1"),
                          check("W1", Outcome::kAccept, 5, {length("a", 0.002)}, "r1")});
  ASSERT_EQ(charts[0].tries.size(), 1u);
  EXPECT_EQ(charts[0].tries[0].outcome, Outcome::kAccept);
}

TEST(JobCharts, JointsOfAnOlderOrderAreKeptAndStepsWithoutOneLeftOut) {
  const auto charts = isometric::joint_charts({{"", "base"}, {"W1", "elbow"}},
                                              {check("W7+W8", Outcome::kAccept, 0, {})});
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].joint, "W1");
  EXPECT_EQ(charts[1].joint, "W7+W8");
  EXPECT_EQ(charts[1].tries.size(), 1u);
}

TEST(JobCharts, NumbersWithoutToleranceOrValueAreNotDrawn) {
  CheckNumber loose = length("loose", 0.5);
  loose.tolerance.reset();
  const auto charts = isometric::joint_charts(
      {{"W1", "elbow"}}, {check("W1", Outcome::kRedo, 0, {loose, length("a", std::nullopt)}),
                          check("W1", Outcome::kAccept, 9, {loose, length("a", 0.0)})});
  EXPECT_EQ(charts[0].number, "a");
  EXPECT_FALSE(charts[0].tries[0].deviation);
  EXPECT_DOUBLE_EQ(*charts[0].tries[1].deviation, 0);
}

// 31 joints of one to fourteen tries each.
JobCharts many_joints() {
  std::vector<isometric::StepName> steps;
  std::vector<CheckRecord> records;
  double now = 0;
  for (int j = 0; j < 31; ++j) {
    const std::string joint = "W" + std::to_string(j + 1);
    steps.push_back({joint, "part_" + std::to_string(j)});
    const int tries = j == 5 ? 14 : j % 4;
    for (int k = 0; k < tries; ++k) {
      const bool is_last = k + 1 == tries;
      now += 60.0 * (2 + (7 * j + 3 * k) % 9);
      CheckRecord record = check(
          joint, is_last ? (j % 5 == 3 ? Outcome::kRemark : Outcome::kAccept) : Outcome::kRedo, now,
          {length("face to corner", 0.009 * std::pow(-0.6, k))});
      record.part = steps.back().part;
      if (is_last && j == 5) record.override_reason = "agreed with the shop";
      if (k == 2 && j == 5) record.numbers[0].deviation.reset();
      if (j == 7 && k == 1) record.at = {1.0, 1.0, "b2"};  // clocks that say nothing
      records.push_back(record);
    }
  }
  JobCharts charts;
  charts.title.spool = "SP1";
  charts.joints = isometric::joint_charts(steps, records);
  return charts;
}

TEST(JobCharts, EveryJointHasItsRowAndEveryCheckedOneItsPlot) {
  const JobCharts charts = many_joints();
  const auto pages = isometric::chart_pages(charts);
  EXPECT_EQ(pages.size(), 4u);  // 31 rows are two pages, 24 plots are two
  const TemporaryFolder folder;
  const auto written =
      isometric::write_pages(pages, "charts", (folder.path() / "charts.png").string());
  ASSERT_TRUE(written);
  EXPECT_EQ(written->size(), 4u);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "charts-4.png"));
}

TEST(JobCharts, MarksStandInTheTriesColumnAndBarsInTheMinutes) {
  JobCharts charts;
  charts.joints = isometric::joint_charts(
      {{"W1", "elbow"}},
      {check("W1", Outcome::kRedo, 0, {}), check("W1", Outcome::kAccept, 600, {})});
  JobCharts none = charts;
  none.joints[0].tries.clear();
  none.joints[0].history.seconds = 0;
  // The first row, from 100 to 200 mm the tries, from 228 to 318 the minutes.
  EXPECT_GT(ink(charts, 0, 100, 31, 130, 36), 40);
  EXPECT_GT(ink(charts, 0, 230, 31, 310, 36), 2000);
  EXPECT_LT(ink(none, 0, 230, 31, 310, 36), 300);  // the ticks alone
}

TEST(JobCharts, AJobWithoutJointsHasAPageThatSaysSo) {
  const JobCharts charts;
  const auto pages = isometric::chart_pages(charts);
  ASSERT_EQ(pages.size(), 1u);
  EXPECT_GT(ink(charts, 0, 14, 30, 80, 40), 20);
}

TEST(JobCharts, EqualJournalsAreEqualFiles) {
  const JobCharts charts = many_joints();
  const auto one = isometric::draw_pdf(isometric::chart_pages(charts), "t");
  const auto other = isometric::draw_pdf(isometric::chart_pages(charts), "t");
  ASSERT_TRUE(one);
  EXPECT_EQ(*one, *other);
}

}  // namespace
}  // namespace spool::test
