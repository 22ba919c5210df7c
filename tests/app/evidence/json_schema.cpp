// The part of JSON Schema 2020-12 that the report's schema uses, to check reports without
// another package.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/evidence/json_schema.h"

#include <algorithm>
#include <regex>

namespace spool::test {
namespace {

using nlohmann::json;

bool is_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void check(const json& schema, const json& value, const std::string& place) {
    for (const auto& [keyword, rule] : schema.items()) check_keyword(keyword, rule, value, place);
  }
  std::vector<std::string> violations;

 private:
  void expect(bool holds, const std::string& place, const std::string& what) {
    if (!holds) violations.push_back((place.empty() ? "/" : place) + ": " + what);
  }

  void check_keyword(const std::string& keyword, const json& rule, const json& value,
                     const std::string& place) {
    if (keyword == "type") {
      const json types = rule.is_array() ? rule : json::array({rule});
      expect(std::any_of(types.begin(), types.end(),
                         [&](const json& type) { return is_type(value, type); }),
             place, "is not of type " + rule.dump() + ": " + value.dump().substr(0, 60));
    } else if (keyword == "$ref") {
      check(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value, place);
    } else if (keyword == "const") {
      expect(value == rule, place, "is not " + rule.dump());
    } else if (keyword == "enum") {
      expect(std::find(rule.begin(), rule.end(), value) != rule.end(), place,
             value.dump() + " is not in the list");
    } else if (keyword == "required") {
      if (!value.is_object()) return;  // what it has to be, "type" says
      for (const auto& key : rule)
        expect(value.contains(key.get<std::string>()), place, "lacks " + key.dump());
    } else if (keyword == "properties") {
      if (!value.is_object()) return;
      for (const auto& [key, member] : value.items()) {
        if (rule.contains(key))
          check(rule.at(key), member, place + "/" + key);
        else
          expect(false, place, "has an undocumented \"" + key + "\"");
      }
    } else if (keyword == "items") {
      if (!value.is_array()) return;
      for (std::size_t i = 0; i < value.size(); ++i)
        check(rule, value[i], place + "/" + std::to_string(i));
    } else if (keyword == "minItems") {
      expect(!value.is_array() || value.size() >= rule.get<std::size_t>(), place, "is too short");
    } else if (keyword == "maxItems") {
      expect(!value.is_array() || value.size() <= rule.get<std::size_t>(), place, "is too long");
    } else if (keyword == "minimum") {
      expect(!value.is_number() || value.get<double>() >= rule.get<double>(), place,
             "is too small");
    } else if (keyword == "maximum") {
      expect(!value.is_number() || value.get<double>() <= rule.get<double>(), place,
             "is too large");
    } else if (keyword == "pattern") {
      expect(!value.is_string() ||
                 std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())),
             place, "does not match " + rule.dump());
    } else if (keyword != "description" && keyword != "title" && keyword != "$schema" &&
               keyword != "$id" && keyword != "$defs") {
      expect(false, place, "the schema uses \"" + keyword + "\", which this check does not know");
    }
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> schema_violations(const json& schema, const json& value) {
  Checker checker(schema);
  checker.check(schema, value, "");
  return checker.violations;
}

}  // namespace spool::test
