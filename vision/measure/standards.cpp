// The tolerances of PFI ES-3 and ISO 13920, typed from them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <limits>
#include <numbers>

#include "vision/measure/rules.h"

namespace spool {
namespace {

constexpr double kMillimetre = 0.001;
constexpr double kMinute = std::numbers::pi / 180 / 60;
constexpr double kAny = std::numeric_limits<double>::infinity();

// Table 1 of ISO 13920, mm. The first range of class A is that of the others too.
constexpr std::array<double, 11> kUpTo = {0.030, 0.120, 0.400, 1.0,  2.0, 4.0,
                                          8.0,   12.0,  16.0,  20.0, kAny};
constexpr std::array<std::array<double, 11>, 4> kLinear = {{
    {1, 1, 1, 2, 3, 4, 5, 6, 7, 8, 9},
    {1, 2, 2, 3, 4, 6, 8, 10, 12, 14, 16},
    {1, 3, 4, 6, 8, 11, 14, 18, 21, 24, 27},
    {1, 4, 7, 9, 12, 16, 21, 27, 32, 36, 40},
}};
// Table 2, minutes, by the shorter leg.
constexpr std::array<double, 3> kLegUpTo = {0.400, 1.0, kAny};
constexpr std::array<std::array<double, 3>, 4> kAngular = {
    {{20, 15, 10}, {45, 30, 20}, {60, 45, 30}, {90, 75, 60}}};
// Table 3, mm, from 30 mm on; a shorter surface is held to the first row.
constexpr std::array<double, 10> kFormUpTo = {0.120, 0.400, 1.0,  2.0,  4.0,
                                              8.0,   12.0,  16.0, 20.0, kAny};
constexpr std::array<std::array<double, 10>, 4> kForm = {{
    {0.5, 1, 1.5, 2, 3, 4, 5, 6, 7, 8},
    {1, 1.5, 3, 4.5, 6, 8, 10, 12, 14, 16},
    {1.5, 3, 5.5, 9, 11, 16, 20, 22, 25, 25},
    {2.5, 5, 9, 14, 18, 26, 32, 36, 40, 40},
}};

template <std::size_t N>
ToleranceTable table(const std::array<double, N>& up_to, const std::array<double, N>& tolerance,
                     double unit, std::string clause) {
  ToleranceTable result{.clause = std::move(clause)};
  for (std::size_t i = 0; i < N; ++i) result.steps.push_back({up_to[i], tolerance[i] * unit});
  return result;
}

}  // namespace

RuleSet pfi_es3() {
  RuleSet rules{.name = "PFI ES-3"};
  // 2.2: 1/8 in (3.0 mm) to NPS 10, 3/16 in (5.0 mm) to 24, 1/4 in (6.0 mm) to 36; 2.3: beyond it
  // 1/16 in (2.0 mm) more for each 12 in of diameter.
  rules.length_by_nps = {
      {{10, 0.003}, {24, 0.005}, {36, 0.006}, {48, 0.008}, {60, 0.010}, {72, 0.012}}, "2.2"};
  // 3.1: 3/64 in a foot or 1/32 in across any diameter, whichever is greater.
  constexpr double kInch = 0.0254;
  rules.alignment = {{{kAny, kInch / 32}}, "3.1"};
  rules.alignment_slope = 3.0 / 64 / 12;
  // 3.1, figure 1: flanges are turned by 1/16 in at most; of what, along or across, it does not
  // say.
  rules.rotation = {{{kAny, kInch / 16}}, "3.1"};
  return rules;
}

RuleSet iso_13920(char linear, char form) {
  const auto l = static_cast<std::size_t>(linear - 'A'), f = static_cast<std::size_t>(form - 'E');
  const std::string name(1, linear);
  RuleSet rules{.name = std::string("ISO 13920-") + linear + form};
  rules.length_by_length = table(kUpTo, kLinear.at(l), kMillimetre, "table 1, class " + name);
  rules.angle = table(kLegUpTo, kAngular.at(l), kMinute, "table 2, class " + name);
  rules.alignment =
      table(kFormUpTo, kForm.at(f), kMillimetre, std::string("table 3, class ") + form);
  return rules;
}

std::optional<RuleSet> standard_rules(std::string_view name) {
  if (name == "pfi-es3") return pfi_es3();
  constexpr std::string_view kIso = "iso-13920-";
  if (!name.starts_with(kIso) || name.size() != kIso.size() + 2) return std::nullopt;
  const char linear = name[kIso.size()], form = name[kIso.size() + 1];
  if (linear < 'A' || linear > 'D' || form < 'E' || form > 'H') return std::nullopt;
  return iso_13920(linear, form);
}

}  // namespace spool
