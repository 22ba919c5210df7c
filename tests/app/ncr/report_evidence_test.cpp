// What is read of an inspection's folder, and what is refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/report_evidence.h"

#include <gtest/gtest.h>

#include "tests/app/ncr/sample_ncr.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool::test {
namespace {

const std::string kHash(64, 'd');

TEST(ReportEvidence, ReadsFeaturesWorstFirstWithTheirNumbers) {
  const TemporaryFolder folder;
  write_report(folder.path(), kHash);
  const auto read = ncr::read_evidence(folder.path(), kHash);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->features.size(), 3U);
  const ncr::Feature& turned = read->features[0];
  EXPECT_EQ(turned.name, "flange-1/holes");
  EXPECT_TRUE(turned.is_angle);
  EXPECT_EQ(turned.status, Verdict::kNotOk);
  EXPECT_DOUBLE_EQ(*turned.deviation, M_PI_2);
  EXPECT_EQ(turned.clause, "PFI ES-3 3.1");
  EXPECT_EQ(turned.probability, 0.0);
  const ncr::Feature& size = read->features[1];
  EXPECT_EQ(size.name, "pipe-1: outside_diameter");
  EXPECT_NEAR(*size.deviation, 0.002, 1e-12);
  EXPECT_FALSE(size.tolerance);
  const ncr::Feature& length = read->features[2];
  EXPECT_FALSE(length.is_angle);
  EXPECT_EQ(length.nominal, 0.3);
  EXPECT_EQ(length.measured, 0.303);
  EXPECT_EQ(length.u, 0.0004);
  EXPECT_EQ(length.tolerance, 0.003);
  EXPECT_EQ(read->corrections, std::vector<std::string>{"Turn flange-1 by 90°."});
  EXPECT_EQ(read->calibration_id, "cal-7");
  EXPECT_EQ(read->decision_rule, "rule of decision");
}

TEST(ReportEvidence, TakesPicturesWithTheCaptionsOfTheReport) {
  const TemporaryFolder folder;
  write_report(folder.path(), kHash);
  const auto read = ncr::read_evidence(folder.path(), kHash);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->pictures.size(), 2U);
  EXPECT_EQ(read->pictures[0].caption, "seen from +x & <y>");
  EXPECT_EQ(read->pictures[1].caption, "seen from -z");
  EXPECT_EQ(read->pictures[1].image.width, 320);
}

TEST(ReportEvidence, RefusesOtherDesignsAndDamagedPictures) {
  const TemporaryFolder folder;
  write_report(folder.path(), kHash);
  expect_refused(ncr::read_evidence(folder.path(), std::string(64, 'e')), ErrorCode::kBadInput,
                 "report.json", "another design");
  write_file(folder.path() / "overlay_2.png", "no picture");
  expect_refused(ncr::read_evidence(folder.path(), kHash), ErrorCode::kBadInput, "overlay_2.png",
                 "PNG");
  write_file(folder.path() / "report.json", "{\"schema\": 7}");
  expect_refused(ncr::read_evidence(folder.path(), kHash), ErrorCode::kBadInput, "report.json",
                 "no report");
}

TEST(ReportEvidence, KeysOfAnotherKindAreLeftOut) {
  const TemporaryFolder folder;
  write_file(folder.path() / "report.json",
             R"({"schema": "spoolsight-report/1", "design": {"sha256": ")" + kHash +
                 R"("}, "dimensions": [7, {"name": 3, "nominal_m": "x"}], "findings": "none",
                   "parts": {"a": 1}, "warnings": [1, null]})");
  const auto read = ncr::read_evidence(folder.path(), kHash);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->features.size(), 1U);
  EXPECT_FALSE(read->features[0].nominal);
  EXPECT_EQ(read->status, Verdict::kNotMeasured);
}

}  // namespace
}  // namespace spool::test
