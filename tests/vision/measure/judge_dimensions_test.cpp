// Tests of what dimensions and sizes say of parts.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/judge_dimensions.h"

#include <gtest/gtest.h>

#include "tests/vision/measure/two_flange_spool.h"

namespace spool {
namespace {

std::vector<PartFinding> all_seen() {
  std::vector<PartFinding> parts(test::kSpoolParts);
  for (int p = 0; p < test::kSpoolParts; ++p) {
    parts[static_cast<std::size_t>(p)].part = p;
    parts[static_cast<std::size_t>(p)].status = Verdict::kSuspicious;
  }
  return parts;
}

Dimension along(std::vector<int> parts, int answers, Verdict status) {
  Dimension dimension;
  dimension.kind = "centre_to_face";
  dimension.parts = std::move(parts);
  dimension.answers = answers;
  dimension.status = status;
  return dimension;
}

TEST(JudgeDimensions, AWrongOneIsItsPartsAndLeavesItsNeighboursOpen) {
  const DesignModel design = test::two_flange_spool();
  std::vector<PartFinding> parts = all_seen();
  parts[test::kFlangeB].status = Verdict::kNotMeasured;
  std::vector<Finding> findings;
  judge_dimensions(
      design,
      {along({test::kFlangeA, test::kPipe1, test::kElbow}, test::kPipe1, Verdict::kOk),
       along({test::kElbow, test::kPipe2, test::kFlangeB}, test::kPipe2, Verdict::kNotOk)},
      parts, findings);
  EXPECT_EQ(parts[test::kFlangeA].status, Verdict::kOk);
  EXPECT_EQ(parts[test::kPipe1].status, Verdict::kOk);
  EXPECT_EQ(parts[test::kElbow].status, Verdict::kSuspicious);
  EXPECT_EQ(parts[test::kPipe2].status, Verdict::kNotOk);
  EXPECT_EQ(parts[test::kFlangeB].status, Verdict::kNotMeasured) << "it was not seen";
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, "misplaced");
  EXPECT_EQ(findings[0].part, "pipe_2");
}

TEST(JudgeDimensions, APartWithoutADimensionOrAlreadyWrongStaysAsItIs) {
  const DesignModel design = test::two_flange_spool();
  std::vector<PartFinding> parts = all_seen();
  parts[test::kPipe1].status = Verdict::kNotOk;
  parts[test::kPipe1].reason = "turned";
  std::vector<Finding> findings;
  judge_dimensions(design, {along({test::kPipe1}, test::kPipe1, Verdict::kOk)}, parts, findings);
  EXPECT_EQ(parts[test::kPipe1].status, Verdict::kNotOk);
  EXPECT_EQ(parts[test::kPipe1].reason, "turned");
  EXPECT_EQ(parts[test::kPipe2].status, Verdict::kSuspicious);
}

TEST(JudgeDimensions, APipeOfTheNextSizeIsOfAnotherSize) {
  const DesignModel design = test::two_flange_spool();
  test::SpoolScan scan;
  scan.pipe_2_radius_m = 0.0508;  // NPS 3 1/2
  std::vector<PartFinding> parts = all_seen();
  std::vector<Finding> findings;
  check_sizes(design, test::features_of(design, scan), "", parts);
  judge_dimensions(design, {}, parts, findings);
  ASSERT_EQ(parts[test::kPipe2].size_checks.size(), 1U);
  EXPECT_NEAR(parts[test::kPipe2].size_checks[0].measured_m, 0.1016, 0.0005);
  EXPECT_EQ(parts[test::kPipe2].status, Verdict::kNotOk);
  EXPECT_EQ(parts[test::kPipe1].size_checks[0].status, Verdict::kOk);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, "wrong_size");
  // Within the mill's tolerance it is of its size.
  scan.pipe_2_radius_m = 0.05715 + 0.0004;
  parts = all_seen();
  check_sizes(design, test::features_of(design, scan), "", parts);
  EXPECT_EQ(parts[test::kPipe2].size_checks[0].status, Verdict::kOk);
}

}  // namespace
}  // namespace spool
