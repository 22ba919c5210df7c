// Claims about the list of everything that an inspection found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/result_rows.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/app/evidence/sample_record.h"

namespace spool::evidence {
namespace {

// base - post - arm, with everything that a list can hold.
class ResultRows : public testing::Test {
 protected:
  ResultRows() {
    for (const char* name : {"base", "post", "arm"}) design_.parts.push_back(part(name));
    for (int i = 0; i < 3; ++i) inspection_.parts.push_back({.part = i});
    inspection_.parts[0].status = Verdict::kOk;
    inspection_.parts[1].status = Verdict::kNotOk;
    inspection_.parts[2].status = Verdict::kSuspicious;

    Dimension out = test::sample_dimensions().front();  // 6.1 mm of 3
    out.parts = {0, 1};
    out.answers = 1;
    Dimension open = out;
    open.name = "datum to arm/face across";
    open.from = "datum";
    open.to = "arm/face";
    open.deviation = 0.002;
    open.status = Verdict::kSuspicious;
    open.parts = {0, 1, 2};
    open.answers = -1;
    Dimension fine = open;
    fine.name = "fine";
    fine.from = "base/axis";
    fine.to = "post/axis";
    fine.deviation = 0.0001;
    fine.parts = {0, 1};
    fine.status = Verdict::kOk;
    Dimension unseen = open;
    unseen.name = "unseen";
    unseen.is_measured = false;
    unseen.status = Verdict::kNotMeasured;
    inspection_.dimensions = {fine, unseen, open, out};

    JointError joint;
    joint.weld = "W1";
    joint.part_near = 0;
    joint.part_far = 1;
    joint.is_measured = joint.is_to_blame = true;
    joint.against_tolerance = 1.5;
    inspection_.chain.joints = {joint};
    inspection_.chain.fit_ups = {{.weld = "W1", .a = "base", .b = "post", .is_measured = true},
                                 {.weld = "W2", .a = "post", .b = "arm"}};
    inspection_.findings = {
        {"misplaced", "post", out.kind + " " + out.name + ": " + out.reason, out.rule},
        {"unexpected", "arm", "Something sticks out of arm.", ""},
        {"symmetry", "", "Two poses explain the scan.", ""}};
  }
  static Part part(const char* name) {
    Part out;
    out.name = name;
    return out;
  }
  [[nodiscard]] std::string text(const ResultRow& row) const {
    switch (row.kind) {
      case ResultKind::kFinding:
        return inspection_.findings.at(row.index).kind;
      case ResultKind::kDimension:
        return inspection_.dimensions.at(row.index).name;
      case ResultKind::kJoint:
        return "joint " + inspection_.chain.joints.at(row.index).weld;
      case ResultKind::kFitUp:
        return "fit-up " + inspection_.chain.fit_ups.at(row.index).weld;
      case ResultKind::kPart:
        break;
    }
    return design_.parts.at(row.index).name;
  }
  [[nodiscard]] std::vector<ResultRow> rows() const { return result_rows(design_, inspection_); }

  DesignModel design_;
  Inspection inspection_;
};

TEST_F(ResultRows, AreOneOfEachWorstFirst) {
  std::vector<std::string> texts;
  for (const ResultRow& row : rows()) texts.push_back(text(row));
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "base/face to post/centre", "post", "joint W1",  // out: 2.0, 2.0, 1.5
                       "datum to arm/face across", "arm",               // open: 0.67, 0.67
                       "unexpected", "symmetry", "fit-up W1",           // open, no limit
                       "unseen", "fit-up W2",                           // not seen
                       "base", "fine"}));                               // ok
}

TEST_F(ResultRows, LightThePartThatAnswersElseBothEnds) {
  using Lit = std::array<int, 2>;
  const std::vector<ResultRow> all = rows();
  EXPECT_EQ(all[0].parts, (Lit{1, -1})) << "the cut length's pipe";
  EXPECT_EQ(all[2].parts, (Lit{0, 1})) << "both sides of the joint";
  EXPECT_EQ(all[3].parts, (Lit{2, -1})) << "the datum is no part";
  EXPECT_EQ(all[5].parts, (Lit{2, -1}));
  EXPECT_EQ(all[6].parts, (Lit{-1, -1}));
  EXPECT_EQ(all.back().parts, (Lit{1, 0}));
}

TEST_F(ResultRows, OpenAPartAtItsWorst) {
  const std::vector<ResultRow> all = rows();
  EXPECT_EQ(worst_row_of(all, 1), 0U);
  EXPECT_EQ(worst_row_of(all, 0), 2U) << "the joint that it is at";
  EXPECT_EQ(worst_row_of(all, 2), 3U);
  EXPECT_FALSE(worst_row_of(all, 7).has_value());
  EXPECT_FALSE(worst_row_of(all, -1).has_value());
}

TEST_F(ResultRows, DecideByADimensionOfTheWorstStatus) {
  EXPECT_EQ(deciding_row(rows(), inspection_, -1), 0U);
  inspection_.chain.joints[0].against_tolerance = 5;
  const std::vector<ResultRow> all = rows();
  ASSERT_EQ(text(all[0]), "joint W1");
  EXPECT_EQ(text(all[*deciding_row(all, inspection_, -1)]), "base/face to post/centre")
      << "the verdict comes from dimensions";
  EXPECT_EQ(text(all[*deciding_row(all, inspection_, 2)]), "datum to arm/face across");
  inspection_.parts[2].status = Verdict::kNotOk;  // and no dimension says why
  const std::vector<ResultRow> worse = rows();
  EXPECT_EQ(worse[*deciding_row(worse, inspection_, 2)].status, Verdict::kNotOk)
      << "never better than the step's part";
  EXPECT_FALSE(deciding_row({}, inspection_, -1).has_value());
}

}  // namespace
}  // namespace spool::evidence
