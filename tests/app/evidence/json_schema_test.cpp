// The checker of reports, checked first.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/evidence/json_schema.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using nlohmann::json;

TEST(SchemaCheck, FindsEachKindOfViolationAndNothingElse) {
  const json schema = json::parse(R"({"type": "object", "required": ["a"], "properties": {
    "a": {"$ref": "#/$defs/share"}, "b": {"type": ["array", "null"], "items": {"type": "integer"}, "minItems": 2, "maxItems": 2},
    "c": {"enum": ["x", "y"]}, "d": {"type": "string", "pattern": "^[0-9]+$"}, "e": {"const": 1}},
    "$defs": {"share": {"type": "number", "minimum": 0, "maximum": 1}}})");
  const struct {
    const char* text;
    std::size_t violations;
  } cases[] = {
      {R"({"a": 0.5})", 0},
      {R"({"a": 1, "b": null, "c": "x", "d": "12", "e": 1})", 0},
      {R"({"a": 0, "b": [1, 2]})", 0},
      {R"({})", 1},
      {R"([])", 1},  // "required" speaks of objects only
      {R"({"a": 1.5})", 1},
      {R"({"a": -1})", 1},
      {R"({"a": "1"})", 1},
      {R"({"a": 1, "b": [1]})", 1},
      {R"({"a": 1, "b": [1, 2, 3]})", 1},
      {R"({"a": 1, "b": [1, 2.5]})", 1},
      {R"({"a": 1, "c": "z"})", 1},
      {R"({"a": 1, "d": "x"})", 1},
      {R"({"a": 1, "e": 2})", 1},
      {R"({"a": 1, "f": 2})", 1},
  };
  for (const auto& [text, violations] : cases)
    EXPECT_EQ(schema_violations(schema, json::parse(text)).size(), violations) << text;
}

TEST(SchemaCheck, DoesNotWaveAnUnknownKeywordThrough) {
  EXPECT_EQ(schema_violations(json::parse(R"({"oneOf": []})"), json(1)).size(), 1U);
}

}  // namespace
}  // namespace spool::test
