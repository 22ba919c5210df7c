// Claims about what is said of each result.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/result_lines.h"

#include <cmath>

#include <gtest/gtest.h>

#include "vision/measure/dimension_text.h"

namespace spool {
namespace {

using evidence::ResultKind;
using evidence::ResultRow;

// flange F1 - pipe P1 - elbow E2 - flange F2: P1 is 4.6 mm too long, E2 turned at W2.
class ResultLines : public testing::Test {
 protected:
  ResultLines() {
    for (const char* name : {"F1", "P1", "E2", "F2"}) {
      Part part;
      part.name = name;
      design_.parts.push_back(part);
      inspection_.parts.push_back({.part = static_cast<int>(design_.parts.size()) - 1});
    }
    Dimension length;
    length.name = "F2/face to E2/centre";
    length.kind = "centre_to_face";
    length.from = "F2/face";
    length.to = "E2/centre";
    length.nominal = 0.3;
    length.is_measured = true;
    length.measured = 0.3046;
    length.deviation = 0.0046;
    length.u = {0.00035, 0, 0};
    length.tolerance = 0.003;
    length.rule = "PFI ES-3 2.2";
    length.probability = 0.01;
    length.status = Verdict::kNotOk;
    length.reason = "Off by 4.6 mm ± 0.7 mm, allowed ± 3.0 mm.";
    length.parts = {1, 2, 3};
    length.answers = 1;
    inspection_.dimensions = {length};
    JointError joint;
    joint.weld = "W2";
    joint.part_near = 1;
    joint.part_far = 2;
    joint.near_port = "P1/out";
    joint.far_port = "E2/in";
    joint.is_measured = joint.is_significant = joint.is_to_blame = true;
    joint.against_tolerance = 2;
    joint.error[0] = 0.003;
    joint.covariance(0, 0) = 1e-8;
    joint.covariance(5, 5) = std::pow(0.25 * M_PI / 180, 2);
    inspection_.chain.joints = {joint};
    Bump bump;
    bump.part = 2;
    bump.kind = BumpKind::kTurn;
    bump.amount = 1.2 * M_PI / 180;
    bump.end = "F2/face";
    bump.at_end_m = 0.007;
    bump.at_end_way = {0, 1, 0};
    bump.seen_from = "P1";
    inspection_.chain.bumps = {bump};
  }
  [[nodiscard]] ui::ResultDetail detail(const ResultRow& row,
                                        LengthStyle style = LengthStyle::kMillimetre) const {
    return result_detail(design_, inspection_, row, style);
  }
  [[nodiscard]] static std::string fact(const ui::ResultDetail& of, const std::string& label) {
    for (const auto& [name, value] : of.facts)
      if (name == label) return value;
    return "none";
  }

  DesignModel design_;
  Inspection inspection_;
  ResultRow length_{ResultKind::kDimension, 0, Verdict::kNotOk, 1.5, {1, -1}};
};

TEST_F(ResultLines, SayNominalMeasuredDeviationLimitRuleAndWhatToDo) {
  const ui::ResultDetail said = detail(length_);
  EXPECT_EQ(said.status, ui::StatusMark::kNotOk);
  EXPECT_EQ(said.name, "F2 face to E2 centre");
  EXPECT_EQ(said.number, "+4.6 mm");
  EXPECT_EQ(said.doubt, "± 0.7 mm, limit ± 3.0 mm, too long");
  EXPECT_EQ(fact(said, "Drawing"), "300.0 mm");
  EXPECT_EQ(fact(said, "Measured"), "304.6 mm");
  EXPECT_EQ(fact(said, "Off by"), "+4.6 mm ± 0.7 mm (k = 2)");
  EXPECT_EQ(fact(said, "Limit"), "± 3.0 mm");
  EXPECT_EQ(fact(said, "Rule"), "PFI ES-3 2.2");
  EXPECT_EQ(fact(said, "Within the limit"), "less than 1 in 20");
  ASSERT_EQ(said.to_do.size(), 1U);
  EXPECT_EQ(said.to_do[0],
            "Turn E2 1.2° clockwise seen from P1 = 7.0 mm at F2/face, towards +y of the drawing.");
  const ui::ResultLine line = result_line(design_, inspection_, length_, LengthStyle::kMillimetre);
  EXPECT_EQ(line.number, "+4.6 mm ± 0.7 mm, limit ± 3.0 mm, too long");
}

TEST_F(ResultLines, SayOneWayOnlyBeyondTheDoubtAndABumpOnlyAcrossItsJoint) {
  inspection_.dimensions[0].deviation = -0.0046;
  EXPECT_EQ(detail(length_).number, "−4.6 mm");
  EXPECT_NE(detail(length_).doubt.find("too short"), std::string::npos);
  inspection_.dimensions[0].u.fit = 0.003;
  EXPECT_EQ(detail(length_).doubt, "± 6.0 mm, limit ± 3.0 mm");
  inspection_.dimensions[0].parts = {2, 3};
  EXPECT_EQ(detail(length_).to_do[0].find("Turn"), std::string::npos);
}

TEST_F(ResultLines, SpeakFeetAndInchesAsTheReportDoes) {
  EXPECT_EQ(fact(detail(length_, LengthStyle::kFeetInch), "Drawing"), "11 13/16\"");
  EXPECT_EQ(detail(length_, LengthStyle::kFeetInch).number, "+3/16\"");
}

TEST_F(ResultLines, SayOfAPartWhatADimensionTellsInTheSameWordsAndUnits) {
  const ResultRow part{ResultKind::kPart, 1, Verdict::kNotOk, 0, {1, -1}};
  inspection_.parts[1].reason = told_by(inspection_.dimensions[0]);
  EXPECT_EQ(detail(part).words.find("F2 face to E2 centre: +4.6 mm ± 0.7 mm, limit ± 3.0 mm"), 0U)
      << detail(part).words;
  EXPECT_EQ(detail(part, LengthStyle::kFeetInch).words.find("F2 face to E2 centre: +3/16\""), 0U);
  inspection_.parts[1].reason = "No point of it was seen.";
  EXPECT_EQ(detail(part).words.find("No point of it was seen."), 0U);
}

TEST_F(ResultLines, SayOfWhatIsOpenWhatWouldSettleIt) {
  Dimension& dimension = inspection_.dimensions[0];
  dimension.status = length_.status = Verdict::kSuspicious;
  dimension.deviation = 0.0013;
  dimension.u.fit = 0.004;
  dimension.probability = 0.53;
  EXPECT_EQ(fact(detail(length_), "Within the limit"), "about 5 in 10");
  EXPECT_EQ(detail(length_).to_do[0],
            "Scan it from nearer and from more sides, or measure it by hand.");
  dimension.probability = 0.03;  // far coarser than the limit
  EXPECT_NE(detail(length_).words.find("too coarsely"), std::string::npos);
  dimension.probability = 0.99;  // and something else keeps it from being ok
  dimension.reason = "Off by 0.1 mm. The unit was guessed.";
  EXPECT_EQ(detail(length_).to_do[0], dimension.reason);
  dimension.is_measured = false;
  dimension.status = length_.status = Verdict::kNotMeasured;
  dimension.reason = "Not measured: its face is not known. Scan it from where it shows.";
  EXPECT_EQ(detail(length_).to_do[0], dimension.reason);
  EXPECT_TRUE(detail(length_).number.empty());
  EXPECT_EQ(fact(detail(length_), "Measured"), "none");
}

TEST_F(ResultLines, SayOfAJointItsErrorAndTheBumpIfItIsToBlame) {
  const ResultRow row{ResultKind::kJoint, 0, Verdict::kNotOk, 2, {1, 2}};
  EXPECT_EQ(detail(row).name, "Joint W2, P1 out to E2 in");
  EXPECT_EQ(detail(row).number, "3.0 mm");
  EXPECT_EQ(detail(row).doubt, "± 0.2 mm, and 0.00° ± 0.50°");
  EXPECT_EQ(fact(detail(row), "Aside"), "3.0 mm ± 0.2 mm (k = 2)");
  EXPECT_EQ(detail(row).to_do[0].substr(0, 7), "Turn E2");
  inspection_.chain.joints[0].is_to_blame = false;
  inspection_.chain.joints[0].is_significant = false;
  EXPECT_NE(detail(row).to_do[0].find("may be chance"), std::string::npos);
}

TEST(ResultText, SaysChancesAndAgesInWords) {
  EXPECT_EQ(chance_text(0.97), "more than 19 in 20");
  EXPECT_EQ(chance_text(0.949), "about 9 in 10");
  EXPECT_EQ(chance_text(0.06), "about 1 in 10");
  EXPECT_EQ(chance_text(0.01), "less than 1 in 20");
  EXPECT_EQ(age_text(0), "just now");
  EXPECT_EQ(age_text(12.9), "12 s ago");
  EXPECT_EQ(age_text(200), "3 min ago");
  EXPECT_EQ(age_text(7300), "2 h ago");
}

}  // namespace
}  // namespace spool
