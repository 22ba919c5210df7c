// The form has every field of the thesis's report, and takes nothing that is not its own.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/form.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace spool::test {
namespace {

// Figures 2-18 to 2-22 of the thesis, typed a second time.
const std::vector<std::pair<const char*, std::vector<const char*>>> kBlocks = {
    {"head", {"place", "issued_to", "ncr_no", "department", "date", "tag_line_no", "job_no"}},
    {"description", {"text"}},
    {"recommended_action", {"action"}},
    {"root_cause", {"text", "inspector", "signature", "date"}},
    {"proposed_disposition", {"text", "name", "signature", "date"}},
    {"acceptance",
     {"client_approval", "authorized_inspector", "qc.signature", "qc.print", "qc.date",
      "contractor.signature", "contractor.print", "contractor.date", "owner.signature",
      "owner.print", "owner.date"}},
    {"completion", {"action_completed", "inspector", "print", "date", "completed"}},
    {"final_sign_off",
     {"qc.signature", "qc.print", "qc.date", "contractor.signature", "contractor.print",
      "contractor.date", "owner.signature", "owner.print", "owner.date",
      "design_engineer.signature", "design_engineer.print", "design_engineer.date"}}};

TEST(Form, HasEveryFieldOfTheThesisAndStartsEmpty) {
  const auto form = ncr::empty_form();
  std::size_t count = 0;
  for (const auto& [block, fields] : kBlocks) {
    for (const char* key : fields) {
      ++count;
      const ncr::FormField* at = ncr::field(form, std::string(block) + "." + key);
      ASSERT_NE(at, nullptr) << block << "." << key;
      EXPECT_EQ(at->block, block);
      EXPECT_FALSE(at->label.empty());
      EXPECT_EQ(at->value, "");
    }
  }
  EXPECT_EQ(form.size(), count);
  std::set<std::string> keys;
  for (const auto& each : form) keys.insert(each.key);
  EXPECT_EQ(keys.size(), count) << "a key is there twice";
  EXPECT_EQ(ncr::field(form, "recommended_action.action")->choices,
            (std::vector<std::string>{"Scrap", "Rework", "Use as is", "Return"}));
}

TEST(Form, TakesWhatAPersonSays) {
  auto form = ncr::empty_form();
  ASSERT_TRUE(ncr::write_fields(
      {{"recommended_action.action", "Use as is"}, {"head.issued_to", "NAME é"}}, form));
  EXPECT_EQ(ncr::field(form, "recommended_action.action")->value, "Use as is");
  EXPECT_EQ(ncr::field(form, "head.issued_to")->value, "NAME é");
}

TEST(Form, RefusesWhatIsNotItsOwn) {
  const struct {
    const char *key, *value, *why;
  } cases[] = {{"head.ncr_no", "X-1", "given"},
               {"acceptance.qc.signature", "NAME", "by hand"},
               {"recommended_action.action", "Burn", "Scrap, Rework"},
               {"head.colour", "red", "no field"}};
  for (const auto& each : cases) {
    auto form = ncr::empty_form();
    const Status done = ncr::write_fields({{each.key, each.value}}, form);
    ASSERT_FALSE(done) << each.key;
    expect_sentence(done.error(), ErrorCode::kBadInput, each.key, each.why);
  }
}

}  // namespace
}  // namespace spool::test
