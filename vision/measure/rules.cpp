// What a set of tolerances says of a length, a facing, an angle.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spool {
namespace {

std::string cited(const RuleSet& rules, const std::string& clause) {
  return clause.empty() ? rules.name : rules.name + " " + clause;
}

}  // namespace

std::optional<double> ToleranceTable::at(double value) const {
  for (const ToleranceStep& step : steps)
    if (value <= step.up_to) return step.tolerance;
  return std::nullopt;
}

std::optional<Tolerance> length_tolerance(const RuleSet& rules, double nps, double length_m,
                                          int fittings) {
  // Of a size that nobody names the smallest pipe's tolerance would be made up.
  std::optional<double> value = nps > 0 ? rules.length_by_nps.at(nps) : std::nullopt;
  const ToleranceTable& table = value ? rules.length_by_nps : rules.length_by_length;
  if (!value) value = rules.length_by_length.at(length_m);
  if (!value) return std::nullopt;
  Tolerance tolerance{*value, cited(rules, table.clause)};
  if (fittings > 0 && rules.fitting_allowance_m > 0) {
    tolerance.value += fittings * rules.fitting_allowance_m;
    tolerance.rule += ", fitting to fitting";
  }
  return tolerance;
}

std::optional<Tolerance> alignment_tolerance(const RuleSet& rules, double diameter_m) {
  const std::optional<double> across_m = rules.alignment.at(diameter_m);
  if (!across_m || !(diameter_m > 0)) return std::nullopt;
  return Tolerance{std::max(rules.alignment_slope, *across_m / diameter_m),
                   cited(rules, rules.alignment.clause)};
}

std::optional<Tolerance> angle_tolerance(const RuleSet& rules, double shorter_leg_m,
                                         double diameter_m) {
  if (rules.angle.steps.empty()) return alignment_tolerance(rules, diameter_m);
  const std::optional<double> value = rules.angle.at(shorter_leg_m);
  if (!value) return std::nullopt;
  return Tolerance{*value, cited(rules, rules.angle.clause)};
}

std::optional<Tolerance> rotation_tolerance(const RuleSet& rules, int holes, double bolt_circle_m) {
  if (holes < 2 || !(bolt_circle_m > 0)) return std::nullopt;
  if (rules.rotation.steps.empty()) {
    if (rules.angle.steps.empty()) return std::nullopt;
    return angle_tolerance(rules, bolt_circle_m, bolt_circle_m);
  }
  const std::optional<double> along_m = rules.rotation.at(bolt_circle_m);
  if (!along_m) return std::nullopt;
  const double arc = *along_m / (bolt_circle_m / 2);
  // The two holes are a chord of the bolt circle apart.
  const double level = *along_m / (bolt_circle_m * std::sin(std::numbers::pi / holes));
  const bool is_arc = rules.rotation_reading == RotationReading::kArc ||
                      (rules.rotation_reading == RotationReading::kStricter && arc <= level);
  return Tolerance{is_arc ? arc : level,
                   cited(rules, rules.rotation.clause) +
                       (is_arc ? ", along the bolt circle" : ", level across two holes")};
}

}  // namespace spool
