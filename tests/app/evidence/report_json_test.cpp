// report.json: every field where the schema says, no number that was not measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/common/json_file.h"
#include "app/evidence/writer.h"
#include "tests/app/evidence/json_schema.h"
#include "tests/app/evidence/sample_record.h"
#include "tests/support/shared_data.h"

namespace spool::evidence {
namespace {

nlohmann::json schema() {
  const auto read = read_json(test::source_dir() / "assets" / "report.schema.json");
  EXPECT_TRUE(read);
  return read ? *read : nlohmann::json();
}

nlohmann::json report_of(const InspectionRecord& record) {
  const auto report = parse_json(report_json(record), "report.json");
  EXPECT_TRUE(report);
  return report ? *report : nlohmann::json();
}

void expect_valid(const nlohmann::json& report) {
  for (const auto& violation : test::schema_violations(schema(), report))
    ADD_FAILURE() << violation;
}

TEST(ReportJson, FollowsThePublishedSchema) { expect_valid(report_of(test::sample_record())); }

TEST(ReportJson, FollowsTheSchemaWhereNothingWasFound) {
  auto record = test::sample_record();
  record.inspection.alignment.found = false;
  record.inspection.alignment.reason = "the picks are collinear";
  const auto report = report_of(record);
  expect_valid(report);
  EXPECT_TRUE(report["alignment"]["T_design_scan"].is_null());
}

TEST(ReportJson, FollowsTheSchemaWithEveryOptionalPart) {
  auto record = test::sample_record();
  record.scan.frame = 7;
  record.scan.kind = "depth folder";
  record.created = "2024-01-02T03:04:05Z";
  record.datum = {"base"};
  record.warnings = {"one"};
  record.inspection.alignment.ambiguous = true;
  record.inspection.alignment.alternatives = {Pose::Identity()};
  WeakDirection weak;
  weak.direction = Vector6d::Unit(2);
  weak.sigma = 0.5;
  weak.text = "sliding along (0, 0, 1)";
  record.inspection.alignment.weak_directions = {weak};
  record.inspection.findings = {{"unexpected", "post", "points beside it", "1 point"}};
  record.over_frames = {{true, 0.0012, 0.0004, 0.6}, {false, 0.0, 0.0, 0.0}};
  const auto report = report_of(record);
  expect_valid(report);
  EXPECT_EQ(report["scan"]["frame"], 7);
  EXPECT_EQ(report["parts"][0]["over_frames"]["u_m"], 0.0004);
  EXPECT_TRUE(report["parts"][1]["over_frames"]["mean_m"].is_null());
}

TEST(ReportJson, HoldsTheNumbersOfTheInspection) {
  const auto report = report_of(test::sample_record());
  EXPECT_EQ(report["schema"], "spoolsight-report/1");
  EXPECT_EQ(report["status"], "suspicious");
  EXPECT_EQ(report["design"]["sha256"], std::string(64, 'a'));
  EXPECT_EQ(report["scan"]["points"], 5);
  EXPECT_EQ(report["scan"]["points_measured"], 4);
  EXPECT_EQ(report["alignment"]["method"], "three-point");
  EXPECT_EQ(report["alignment"]["T_design_scan"].size(), 16U);
  EXPECT_EQ(report["declutter"]["points_contradicting"], 1);
  EXPECT_EQ(report["parts"][0]["name"], "base");
  EXPECT_EQ(report["parts"][0]["deviation"]["rms_m"], 0.002);
  EXPECT_EQ(report["parts"][1]["status"], "not_measured");
}

TEST(ReportJson, HoldsEveryDimensionInItsUnitAndNoNumberThatWasNotMeasured) {
  auto record = test::sample_record();
  record.inspection.dimensions = test::sample_dimensions();
  record.inspection.datum = "base/face and the axis of the pipe on it";
  record.inspection.parts[0].size_checks = {
      {"outside_diameter", 0.1143, 0.1016, 0.0002, Verdict::kNotOk, "another size"}};
  const auto report = report_of(record);
  expect_valid(report);
  EXPECT_EQ(report["datum_text"], record.inspection.datum);
  EXPECT_EQ(report["parts"][0]["size_checks"][0]["measured_m"], 0.1016);
  ASSERT_EQ(report["dimensions"].size(), 3U);
  const auto& length = report["dimensions"][0];
  EXPECT_EQ(length["measured_m"], 0.5061);
  EXPECT_DOUBLE_EQ(length["u_m"].get<double>(), 0.0005);
  EXPECT_EQ(length["budget_m"]["scale"], 0.0004);
  EXPECT_EQ(length["coverage_factor"], 2);
  EXPECT_EQ(length["tolerance_m"], 0.003);
  EXPECT_EQ(length["rule"], "PFI ES-3 2.2");
  EXPECT_EQ(length["conformance_probability"], 0.001);
  EXPECT_EQ(length["status"], "not_ok");
  const auto& angle = report["dimensions"][1];
  EXPECT_TRUE(angle.contains("measured_rad"));
  EXPECT_FALSE(angle.contains("measured_m"));
  EXPECT_FALSE(angle.contains("tolerance_rad"));
  EXPECT_FALSE(angle.contains("conformance_probability"));
  const auto& unseen = report["dimensions"][2];
  EXPECT_FALSE(unseen.contains("measured_rad"));
  EXPECT_FALSE(unseen.contains("u_rad"));
  EXPECT_EQ(unseen["tolerance_rad"], 0.0039);
}

TEST(ReportJson, GivesNullForWhatWasNotMeasured) {
  auto record = test::sample_record();
  record.inspection.scan_rms_m = std::numeric_limits<double>::quiet_NaN();
  record.inspection.alignment.covariance(5, 5) = std::numeric_limits<double>::infinity();
  const std::string text = report_json(record);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf,"), std::string::npos);
  const auto report = report_of(record);
  expect_valid(report);
  EXPECT_TRUE(report["scan_quality"]["rms_m"].is_null());
  EXPECT_TRUE(report["alignment"]["covariance"][35].is_null());
  // A part without points has no mean of 0: that would read as perfect.
  EXPECT_TRUE(report["parts"][1]["deviation"]["mean_m"].is_null());
}

TEST(ReportJson, IsTheSameTwice) {
  EXPECT_EQ(report_json(test::sample_record()), report_json(test::sample_record()));
}

}  // namespace
}  // namespace spool::evidence
