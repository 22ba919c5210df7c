// A shop's own tolerances from a JSON file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/rule_file.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string_view>

#include "app/common/json_file.h"

namespace spool {
namespace {

constexpr double kMillimetre = 0.001;
constexpr double kDegree = std::numbers::pi / 180;

// How a table's numbers are spelled and what they are in metres, inches or radians.
struct TableKeys {
  const char* up_to;
  double up_to_unit;
  const char* tolerance;
  double tolerance_unit;
};

void refuse_other_keys(const nlohmann::json& json, std::initializer_list<std::string_view> known,
                       JsonObject& object) {
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      object.fail(key, "is no key of a rule file; see --help and ARCHITECTURE.md");
}

Status read_table(const nlohmann::json& json, const std::string& file, const std::string& where,
                  const TableKeys& keys, ToleranceTable& table) {
  JsonObject object(json, file, where);
  refuse_other_keys(json, {"clause", "steps", "slope", "reading"}, object);
  table.clause = object.text_or("clause", "");
  const nlohmann::json& steps = object.array("steps");
  double last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    JsonObject step(steps[i], file, where + ".steps[" + std::to_string(i) + "]");
    refuse_other_keys(steps[i], {keys.up_to, keys.tolerance}, step);
    const bool is_last = i + 1 == steps.size();
    const double up_to = is_last && !step.has(keys.up_to)
                             ? std::numeric_limits<double>::infinity()
                             : step.number(keys.up_to) * keys.up_to_unit;
    const double tolerance = step.number(keys.tolerance) * keys.tolerance_unit;
    if (!step.error() && !(tolerance > 0)) step.fail(keys.tolerance, "has to be over 0");
    if (!step.error() && !(up_to > last)) step.fail(keys.up_to, "has to be over the step before");
    if (step.error()) return *step.error();
    table.steps.push_back({up_to, tolerance});
    last = up_to;
  }
  if (!object.error() && table.steps.empty()) object.fail("steps", "has to hold a step at least");
  if (object.error()) return *object.error();
  return {};
}

}  // namespace

Result<RuleSet> read_rules(const std::filesystem::path& path) {
  const auto json = read_json(path);
  if (!json) return json.error();
  const std::string file = path.string();
  JsonObject object(*json, file);
  refuse_other_keys(*json,
                    {"name", "length_by_nps", "length_by_length", "alignment", "angle", "rotation",
                     "fitting_allowance_mm"},
                    object);
  RuleSet rules;
  rules.name = object.text_or("name", path.stem().string());
  rules.fitting_allowance_m = kMillimetre * object.number_or("fitting_allowance_mm", 0);
  if (!object.error() && rules.fitting_allowance_m < 0)
    object.fail("fitting_allowance_mm", "may not be under 0");
  if (object.error()) return *object.error();
  const TableKeys by_nps{"up_to_nps", 1, "tolerance_mm", kMillimetre};
  const TableKeys by_length{"up_to_mm", kMillimetre, "tolerance_mm", kMillimetre};
  const TableKeys of_angle{"up_to_mm", kMillimetre, "tolerance_deg", kDegree};
  struct Row {
    const char* key;
    const TableKeys& keys;
    ToleranceTable& table;
  };
  const Row rows[] = {{"length_by_nps", by_nps, rules.length_by_nps},
                      {"length_by_length", by_length, rules.length_by_length},
                      {"alignment", by_length, rules.alignment},
                      {"angle", of_angle, rules.angle},
                      {"rotation", by_length, rules.rotation}};
  for (const Row& row : rows) {
    if (!object.has(row.key)) continue;
    if (auto status = read_table((*json)[row.key], file, row.key, row.keys, row.table); !status)
      return status.error();
  }
  if (object.has("alignment")) {
    JsonObject alignment((*json)["alignment"], file, "alignment");
    rules.alignment_slope = alignment.number_or("slope", 0);
    if (!alignment.error() && rules.alignment_slope < 0)
      alignment.fail("slope", "may not be under 0");
    if (alignment.error()) return *alignment.error();
  }
  if (object.has("rotation")) {
    JsonObject rotation((*json)["rotation"], file, "rotation");
    const std::string reading = rotation.text_or("reading", "stricter");
    if (reading == "arc")
      rules.rotation_reading = RotationReading::kArc;
    else if (reading == "level")
      rules.rotation_reading = RotationReading::kLevel;
    else if (reading != "stricter")
      rotation.fail("reading", "has to be stricter, arc or level");
    if (rotation.error()) return *rotation.error();
  }
  return rules;
}

Result<RuleSet> rules_of(const std::string& name_or_file) {
  if (const auto standard = standard_rules(name_or_file)) return *standard;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(name_or_file, ignored))
    return Error{ErrorCode::kBadInput,
                 name_or_file +
                     ": is no standard that is known and no file; use pfi-es3, "
                     "iso-13920-BF (or other classes) or a file"};
  return read_rules(name_or_file);
}

}  // namespace spool
