// Numbers of a check from a report.json written down by hand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/report_check.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool::test {
namespace {

constexpr char kReport[] = R"({"schema": "spoolsight-report/1", "design": {"sha256": "d1"},
 "parts": [{"name": "pipe-1", "status": "not_ok",
            "pose_error": {"translation_m": [0.001, 0, 0], "rotation_rad": [0, 0, 0.01]},
            "size_checks": [{"quantity": "diameter", "nominal_m": 0.1143, "measured_m": 0.115,
                             "u_m": 0.0002, "status": "ok"}]},
           {"name": "pipe-11", "status": "ok", "pose_error": null, "size_checks": []}],
 "dimensions": [
  {"name": "length", "kind": "centre_to_face", "from": "elbow-1/centre", "to": "pipe-1/end",
   "nominal_m": 0.5, "measured_m": 0.503, "deviation_m": 0.003, "u_m": 0.0004,
   "tolerance_m": 0.0016, "status": "not_ok"},
  {"name": "turn", "kind": "angle", "from": "pipe-1/axis", "to": "pipe-2/axis",
   "nominal_rad": 1.5, "measured_rad": null, "status": "not_measured"},
  {"name": "other", "kind": "angle", "from": "pipe-11/axis", "to": "pipe-2/axis",
   "nominal_rad": 1.5, "status": "ok"}]})";

Part pipe() {
  Part part;
  part.name = "pipe-1";
  part.T_design_part.translation() = Eigen::Vector3d(1, 2, 3);
  return part;
}

TEST(ReportCheck, TakesWhatBelongsToThePart) {
  const TemporaryFolder folder;
  const auto path = write_file(folder.path() / "report.json", kReport);
  const auto check = job::check_from_report(path, pipe(), "d1");
  ASSERT_TRUE(check) << check.error().message;
  EXPECT_EQ(check->status, "not_ok");
  ASSERT_EQ(check->numbers.size(), 3u);
  EXPECT_EQ(check->numbers[0].name, "diameter");
  EXPECT_EQ(check->numbers[1].name, "length");
  EXPECT_EQ(check->numbers[1].unit, "m");
  EXPECT_DOUBLE_EQ(*check->numbers[1].measured, 0.503);
  EXPECT_DOUBLE_EQ(*check->numbers[1].tolerance, 0.0016);
  EXPECT_EQ(check->numbers[2].unit, "rad");
  EXPECT_FALSE(check->numbers[2].measured) << "null is no number";
  ASSERT_TRUE(check->T_design_part);
  EXPECT_NEAR((*check->T_design_part)[3], 1.001, 1e-12);
  EXPECT_EQ(check->report_sha256.size(), 64u);
}

TEST(ReportCheck, RefusesAnotherDesignAnotherFileAndAMissingPart) {
  const TemporaryFolder folder;
  const auto path = write_file(folder.path() / "report.json", kReport);
  expect_refused(job::check_from_report(path, pipe(), "d2"), ErrorCode::kBadInput, "report.json",
                 "another design");
  Part unknown = pipe();
  unknown.name = "tee-9";
  expect_refused(job::check_from_report(path, unknown, "d1"), ErrorCode::kBadInput, "report.json",
                 "nothing of tee-9");
  for (const char* text : {"{}", "[]", "3", R"({"schema": "spoolsight-job/1"})"}) {
    const auto other = write_file(folder.path() / "other.json", text);
    expect_refused(job::check_from_report(other, pipe(), "d1"), ErrorCode::kBadInput, "other.json",
                   "is no report");
  }
}

}  // namespace
}  // namespace spool::test
