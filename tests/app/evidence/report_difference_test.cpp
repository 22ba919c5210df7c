// What counts as a difference between two reports, and what does not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/report_difference.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using evidence::compare_reports;
using nlohmann::json;

const json kReport = {{"created", "2026-11-29T06:00:00Z"},
                      {"scan", {{"file", "a/scan.ply"}, {"points", 7}}},
                      {"parts", {{{"name", "P1"}, {"status", "ok"}, {"mean_m", 0.25}}}},
                      {"warnings", {"a/scan.ply: has no unit"}},
                      {"timing_s", {{"find", 1.5}}}};

TEST(ReportDifference, IsNoneForTheSameAtAnotherTimeAndPlace) {
  json again = kReport;
  again["created"] = "2027-01-01T00:00:00Z";
  again["timing_s"]["find"] = 9;
  again["scan"]["file"] = "b/scan.ply";
  again["warnings"][0] = "b/scan.ply: has no unit";
  again["parts"][0]["mean_m"] = 0.25 + 0.9e-6;
  const auto same = compare_reports(kReport, again, {.renamed = {{"b/scan.ply", "a/scan.ply"}}});
  EXPECT_TRUE(same.differences.empty()) << same.differences.front();
  EXPECT_EQ(same.numbers, 2u);
  EXPECT_NEAR(same.largest, 0.9e-6, 1e-12);  // rounding of 0.25 + 0.9e-6
}

TEST(ReportDifference, IsToldWithItsPlace) {
  const auto difference = [](const char* pointer, const json& value) {
    json again = kReport;
    again[json::json_pointer(pointer)] = value;
    const auto differences = compare_reports(kReport, again).differences;
    return differences.size() == 1 ? differences.front() : std::to_string(differences.size());
  };
  EXPECT_EQ(difference("/parts/0/status", "not_ok"),
            "/parts/0/status: is \"not_ok\" and was \"ok\"");
  EXPECT_EQ(difference("/parts/0/mean_m", 0.250002), "/parts/0/mean_m: is 0.250002 and was 0.25");
  EXPECT_EQ(difference("/parts/0/mean_m", nullptr), "/parts/0/mean_m: is null and was 0.25");
  EXPECT_EQ(difference("/parts/0/more", 1), "/parts/0/more: is 1 and was null");
  EXPECT_EQ(difference("/parts", json::array()).substr(0, 15), "/parts: is [] a");
  EXPECT_EQ(difference("/warnings/0", "b"),
            "/warnings/0: is \"b\" and was \"a/scan.ply: has no unit\"");
}

// One frame cannot say again what many did; what they are said to have shown is none of its
// numbers.
TEST(ReportDifference, CountsWhatManyFramesSaidAndOneCannotSayAgain) {
  json stored = kReport;
  stored["parts"][0]["over_frames"] = {{"mean_m", 0.001}, {"coverage", 0.5}};
  const auto made_again = compare_reports(stored, kReport);
  EXPECT_TRUE(made_again.differences.empty()) << made_again.differences.front();
  EXPECT_EQ(made_again.over_frames, 1u);
  EXPECT_EQ(compare_reports(kReport, stored).differences.size(), 1u) << "it was not there";
}

}  // namespace
}  // namespace spool::test
