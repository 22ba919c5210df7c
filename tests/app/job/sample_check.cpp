// A check with every field filled, each number another.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/job/sample_check.h"

#include <iomanip>
#include <sstream>

namespace spool::test {

job::CheckRecord sample_check(int seed) {
  job::CheckRecord record;
  record.step = seed;
  record.part = "pipe-" + std::to_string(seed);
  record.joint = "W" + std::to_string(seed);
  record.phase = job::Phase::kBeforeWeld;
  record.outcome = job::Outcome::kRemark;
  record.status = "suspicious";
  record.remark = "root 3 mm, \"tight\" at the top\nsee picture; M\xc3\xbcller";
  record.operator_name = "J. O'Neil";
  record.override_reason = "foreman";
  record.picture = "check_" + std::to_string(seed) + ".png";
  record.report_sha256 = std::string(64, 'a');
  record.at = {1.8e9 + seed, 1000.125 + seed, "boot-a"};
  record.T_design_part.emplace();
  for (std::size_t i = 0; i < 16; ++i) (*record.T_design_part)[i] = 0.1 * double(i) + seed / 3.0;
  record.covariance.emplace();
  for (std::size_t i = 0; i < 36; ++i) (*record.covariance)[i] = 1e-9 * double(i) / 7;
  record.numbers = {
      {"length", "centre_to_face", "m", 0.5, 0.503 + seed * 1e-4, 0.003, 0.0004, 0.0016, "not_ok"},
      {"rotation", "rotation", "rad", 0.0, std::nullopt, std::nullopt, std::nullopt, 0.01,
       "not_measured"}};
  return record;
}

std::string text_of(const job::CheckRecord& record) {
  std::ostringstream text;
  text << std::setprecision(17) << record.id << '|' << record.step << '|' << record.part << '|'
       << record.joint << '|' << name(record.phase) << '|' << name(record.outcome) << '|'
       << record.status << '|' << record.remark << '|' << record.operator_name << '|'
       << record.override_reason << '|' << record.picture << '|' << record.report_sha256 << '|'
       << record.at.wall_s << '|' << record.at.boot_s << '|' << record.at.boot;
  if (record.T_design_part)
    for (const double each : *record.T_design_part) text << ' ' << each;
  if (record.covariance)
    for (const double each : *record.covariance) text << ' ' << each;
  for (const job::CheckNumber& each : record.numbers) {
    text << '\n' << each.name << '|' << each.kind << '|' << each.unit << '|' << each.status;
    for (const auto& number : {each.nominal, each.measured, each.deviation, each.u, each.tolerance})
      text << '|' << (number ? std::to_string(*number) : "none");
  }
  return text.str();
}

}  // namespace spool::test
