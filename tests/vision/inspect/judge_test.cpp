// What may be said of parts and of the whole before features are fitted: never ok.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/judge.h"

#include <gtest/gtest.h>

namespace spool {
namespace {

DesignModel three_parts() {
  DesignModel design;
  design.parts.resize(3);
  return design;
}

TEST(Verdict, WorstIsInTheOrderOfTheReport) {
  const std::vector<Verdict> worst_first = {Verdict::kNotOk, Verdict::kSuspicious,
                                            Verdict::kNotMeasured, Verdict::kOk};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b)
      EXPECT_EQ(worse(worst_first[a], worst_first[b]), worst_first[std::min(a, b)]);
}

TEST(Verdict, NamesAreThoseOfTheReport) {
  EXPECT_EQ(name(Verdict::kOk), "ok");
  EXPECT_EQ(name(Verdict::kSuspicious), "suspicious");
  EXPECT_EQ(name(Verdict::kNotOk), "not_ok");
  EXPECT_EQ(name(Verdict::kNotMeasured), "not_measured");
  for (const AlignMethod method : {AlignMethod::kPose, AlignMethod::kThreePoint,
                                   AlignMethod::kPrincipalAxes, AlignMethod::kFind})
    EXPECT_EQ(parse_align_method(name(method)), method);
  EXPECT_EQ(parse_align_method("best-fit"), std::nullopt);
}

TEST(Judge, SeenIsSuspiciousUnseenIsNotMeasuredNothingIsOk) {
  const DesignModel design = three_parts();
  Alignment alignment;
  alignment.found = true;
  std::vector<PartDeviation> deviations(3);
  deviations[0] = {.points = 500, .coverage = 0.5};
  deviations[1] = {.points = 500, .coverage = 0.05};
  const auto parts = judge_parts(design, deviations, alignment);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].status, Verdict::kSuspicious);
  EXPECT_NE(parts[0].reason.find("no dimension of the drawing was measured"), std::string::npos);
  EXPECT_EQ(parts[1].status, Verdict::kNotMeasured);
  EXPECT_EQ(parts[1].reason,
            "Only 5 % of its surface was seen (500 points); scan it from more sides.");
  EXPECT_EQ(parts[2].status, Verdict::kNotMeasured);
  EXPECT_NE(parts[2].reason.find("not seen, or it is not there"), std::string::npos);
  Inspection inspection;
  inspection.alignment = alignment;
  inspection.parts = parts;
  judge_whole(inspection);
  EXPECT_EQ(inspection.status, Verdict::kSuspicious);
  EXPECT_EQ(
      inspection.status_reason,
      "No dimension of the drawing was measured, so no tolerance is judged; 1 of 3 parts were seen "
      "well enough to compare.");
}

TEST(Judge, TheReasonLeadsWithWhatWasFoundAndCountsOnlyWhatWasSeen) {
  Inspection inspection;
  inspection.alignment.found = true;
  inspection.parts.resize(2);
  inspection.parts[0].status = Verdict::kNotOk;
  inspection.parts[0].deviation = {.points = 500, .coverage = 0.5};
  inspection.parts[1].status = Verdict::kSuspicious;  // it hangs on the other, and nothing shows
  inspection.findings = {{"scale", "", "A unit was guessed.", ""},
                         {"misplaced", "elbow", "elbow is turned.", ""}};
  judge_whole(inspection);
  EXPECT_EQ(inspection.status, Verdict::kNotOk);
  EXPECT_EQ(
      inspection.status_reason,
      "elbow is turned. No dimension of the drawing was measured, so no tolerance is judged; 1 "
      "of 2 parts were seen well enough to compare.");
  inspection.findings.push_back({"missing", "cap", "cap is missing.", ""});
  judge_whole(inspection);
  EXPECT_EQ(inspection.status_reason.find("elbow is turned. (and 1 more finding) No dimension"),
            0U);
}

TEST(Judge, TheWholeIsNoBetterThanItsDimensionsAndCountsThem) {
  Inspection inspection;
  inspection.alignment.found = true;
  inspection.parts.resize(1);
  inspection.parts[0].status = Verdict::kOk;
  inspection.parts[0].deviation = {.points = 500, .coverage = 0.5};
  inspection.dimensions.resize(3);
  inspection.dimensions[0].status = inspection.dimensions[1].status = Verdict::kOk;
  inspection.dimensions[2].status = Verdict::kSuspicious;
  judge_whole(inspection);
  EXPECT_EQ(inspection.status, Verdict::kSuspicious);
  EXPECT_EQ(
      inspection.status_reason,
      "Of 3 dimensions 2 are proved within tolerance and 0 out of it, 1 cannot be told, 0 were "
      "not measured; 1 of 1 parts were seen well enough to compare.");
  inspection.dimensions[2].status = Verdict::kOk;
  judge_whole(inspection);
  EXPECT_EQ(inspection.status, Verdict::kOk);
}

TEST(Judge, WithoutAPoseNothingIsMeasured) {
  Inspection inspection;
  inspection.alignment.reason = "because";
  inspection.parts = judge_parts(three_parts(), {}, inspection.alignment);
  for (const PartFinding& part : inspection.parts) EXPECT_EQ(part.status, Verdict::kNotMeasured);
  judge_whole(inspection);
  EXPECT_EQ(inspection.status, Verdict::kNotMeasured);
  EXPECT_EQ(inspection.status_reason, "because");
}

TEST(Judge, AGuessedUnitAndOtherPosesAreFindings) {
  Alignment alignment;
  alignment.found = true;
  alignment.ambiguous = true;
  alignment.alternatives.resize(3);
  const auto findings = collect_findings(alignment, {.units_confirmed = false});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].kind, "scale");
  EXPECT_EQ(findings[1].kind, "symmetry");
  EXPECT_EQ(findings[1].text.substr(0, 12), "3 more poses");
}

}  // namespace
}  // namespace spool
