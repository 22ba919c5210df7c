// The report as JSON keeps to its published schema and loses nothing of the form.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/evidence/json_schema.h"
#include "tests/app/ncr/sample_ncr.h"
#include "tests/support/shared_data.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

using nlohmann::json;

void expect_valid(const ncr::NcrDocument& document) {
  const json schema = json::parse(*read_file(source_dir() / "assets/ncr.schema.json"));
  for (const auto& each : schema_violations(schema, json::parse(ncr::ncr_json(document))))
    ADD_FAILURE() << each;
}

TEST(NcrJson, KeepsToItsSchema) {
  expect_valid(sample_ncr());
  ncr::NcrDocument bare;
  bare.form = ncr::empty_form();
  ncr::set_number("J-S-NCR-1000", bare);
  expect_valid(bare);
}

TEST(NcrJson, HoldsEveryFieldAndNullWhereItIsToBeFilledIn) {
  const ncr::NcrDocument document = sample_ncr();
  const json written = json::parse(ncr::ncr_json(document));
  ASSERT_EQ(written["form"].size(), document.form.size());
  for (std::size_t k = 0; k < document.form.size(); ++k) {
    const ncr::FormField& each = document.form[k];
    EXPECT_EQ(written["form"][k]["key"], each.key);
    if (each.value.empty()) {
      EXPECT_TRUE(written["form"][k]["value"].is_null()) << each.key;
    } else {
      EXPECT_EQ(written["form"][k]["value"], each.value) << each.key;
    }
  }
  const json& worst = written["features"][0];
  EXPECT_EQ(worst["status"], "not_ok");
  EXPECT_EQ(worst["deviation_m"], 0.0061);
  EXPECT_EQ(worst["u_m"], 0.0005);
}

}  // namespace
}  // namespace spool::test
