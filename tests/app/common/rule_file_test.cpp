// Tests of a shop's own tolerances: read as written, refused with the reason.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/rule_file.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool {
namespace {

constexpr const char* kWhole = R"({"name": "Shop 7",
  "length_by_nps": {"clause": "4.1", "steps": [{"up_to_nps": 6, "tolerance_mm": 1.5},
                                               {"up_to_nps": 12, "tolerance_mm": 2}]},
  "length_by_length": {"steps": [{"tolerance_mm": 4}]},
  "alignment": {"clause": "4.3", "slope": 0.002, "steps": [{"tolerance_mm": 0.5}]},
  "angle": {"clause": "4.4", "steps": [{"up_to_mm": 500, "tolerance_deg": 0.5},
                                       {"tolerance_deg": 0.25}]},
  "rotation": {"clause": "4.5", "reading": "arc", "steps": [{"tolerance_mm": 1}]},
  "fitting_allowance_mm": 2})";

class RuleFile : public testing::Test {
 protected:
  std::string written(const std::string& text) {
    const auto path = folder_.path() / "rules.json";
    test::write_file(path, text);
    return path.string();
  }
  test::TemporaryFolder folder_;
};

TEST_F(RuleFile, IsReadAsItIsWritten) {
  const auto rules = rules_of(written(kWhole));
  ASSERT_TRUE(rules) << rules.error().message;
  const auto length = length_tolerance(*rules, 4, 1);
  EXPECT_DOUBLE_EQ(length->value, 0.0015);
  EXPECT_EQ(length->rule, "Shop 7 4.1");
  EXPECT_DOUBLE_EQ(length_tolerance(*rules, 12, 1)->value, 0.002);
  EXPECT_DOUBLE_EQ(length_tolerance(*rules, 14, 1)->value, 0.004) << "by length where by size ends";
  EXPECT_DOUBLE_EQ(length_tolerance(*rules, 4, 1, 2)->value, 0.0055);
  EXPECT_DOUBLE_EQ(alignment_tolerance(*rules, 0.1)->value, 0.005);
  EXPECT_DOUBLE_EQ(alignment_tolerance(*rules, 1.0)->value, 0.002);
  EXPECT_NEAR(angle_tolerance(*rules, 0.5, 0.1)->value, 0.5 * std::numbers::pi / 180, 1e-12);
  EXPECT_DOUBLE_EQ(rotation_tolerance(*rules, 4, 0.1)->value, 0.02);
  EXPECT_EQ(rotation_tolerance(*rules, 4, 0.1)->rule, "Shop 7 4.5, along the bolt circle");
  EXPECT_NEAR(angle_tolerance(*rules, 0.51, 0.1)->value, 0.25 * std::numbers::pi / 180, 1e-12);
}

TEST_F(RuleFile, MayLeaveOutWhatIsNotJudged) {
  const auto rules = rules_of(written("{}"));
  ASSERT_TRUE(rules) << rules.error().message;
  EXPECT_EQ(rules->name, "rules");
  EXPECT_FALSE(length_tolerance(*rules, 4, 1));
  EXPECT_FALSE(alignment_tolerance(*rules, 0.1));
}

TEST_F(RuleFile, IsRefusedWithTheReason) {
  struct Row {
    const char* text;
    const char* says;
  };
  const Row rows[] = {
      {R"({"lenght_by_nps": {"steps": []}})", "lenght_by_nps"},
      {R"({"length_by_nps": {"steps": []}})", "steps"},
      {R"({"length_by_nps": {"steps": [{"up_to_nps": 6}]}})", "tolerance_mm"},
      {R"({"length_by_nps": {"steps": [{"up_to_nps": 6, "tolerance_mm": 0}]}})", "over 0"},
      {R"({"length_by_nps": {"steps": [{"up_to_nps": 6, "tolerance_mm": -3}]}})", "over 0"},
      {R"({"length_by_nps": {"steps": [{"up_to_nps": 6, "tolerance_m": 1}]}})", "tolerance_m"},
      {R"({"length_by_nps": {"steps": [{"up_to_nps": 6, "tolerance_mm": 1},
                                       {"up_to_nps": 4, "tolerance_mm": 2}]}})",
       "over the step before"},
      {R"({"length_by_nps": {"steps": [{"tolerance_mm": 1}, {"up_to_nps": 4, "tolerance_mm": 2}]}})",
       "up_to_nps"},
      {R"({"alignment": {"slope": -1, "steps": [{"tolerance_mm": 1}]}})", "slope"},
      {R"({"rotation": {"reading": "chord", "steps": [{"tolerance_mm": 1}]}})", "stricter"},
      {R"({"fitting_allowance_mm": -1})", "fitting_allowance_mm"},
      {R"([1, 2])", "object"},
      {R"({"angle": 3})", "angle"},
  };
  for (const Row& row : rows) {
    const auto rules = rules_of(written(row.text));
    ASSERT_FALSE(rules) << row.text;
    EXPECT_EQ(rules.error().code, ErrorCode::kBadInput);
    EXPECT_NE(rules.error().message.find("rules.json"), std::string::npos);
    EXPECT_NE(rules.error().message.find(row.says), std::string::npos) << rules.error().message;
  }
  const auto missing = rules_of("no-such-standard");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("no standard that is known"), std::string::npos);
}

}  // namespace
}  // namespace spool
