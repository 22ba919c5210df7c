// One check of a step at the table, as the journal keeps it for good.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spool::job {

enum class Phase { kBeforeTack, kAfterTack, kBeforeWeld, kAfterWeld };
[[nodiscard]] std::string_view name(Phase phase);  // before-tack after-tack before-weld after-weld
[[nodiscard]] std::optional<Phase> parse_phase(std::string_view text);

enum class Outcome { kAccept, kRemark, kRedo };        // kRemark: accepted, with a remark
[[nodiscard]] std::string_view name(Outcome outcome);  // accept remark redo
[[nodiscard]] std::optional<Outcome> parse_outcome(std::string_view text);

// When something was: the wall's clock for people, which may be set back or forward at any time,
// and the machine's own, which only goes on but starts anew with every boot.
struct Stamp {
  double wall_s = 0;  // since 1970, UTC
  double boot_s = 0;  // since this machine was started, sleep included
  std::string boot;   // which start that was; "" unknown
};
[[nodiscard]] Stamp now();

// Seconds from a to the later b: by the machine's clock within one boot, else by the wall's where
// that went forward; nothing where neither tells.
[[nodiscard]] std::optional<double> seconds_between(const Stamp& a, const Stamp& b);

// 2026-11-29T06:15:00.250Z; "-" for what is no time of a year with four digits.
[[nodiscard]] std::string utc_text(double wall_s);

// A number that was measured at a check; missing where it was not.
struct CheckNumber {
  std::string name, kind, unit;  // unit: m or rad
  std::optional<double> nominal, measured, deviation, u, tolerance;
  std::string status;  // ok suspicious not_ok not_measured
};

struct CheckRecord {
  std::int64_t id = 0;  // from 1 in the order of writing; 0: not written yet
  int step = 0;         // from 1, as the order was then
  std::string part;
  std::string joint;  // welds that the step makes, "W5+W6"; "" of the base
  Phase phase = Phase::kAfterTack;
  Outcome outcome = Outcome::kRedo;
  std::string status;  // of the part, as measured
  std::string remark, operator_name;
  std::string override_reason;  // why it was accepted against the numbers; "" it was not
  std::string picture;          // file below the job's evidence/; "" none
  std::string report_sha256;    // of the report that the numbers are from
  Stamp at;
  // Row-major T_design_part as built and its covariance (m, rad; the part's own frame).
  std::optional<std::array<double, 16>> T_design_part;
  std::optional<std::array<double, 36>> covariance;
  std::vector<CheckNumber> numbers;
};

// A capture in evidence/: which check it shows, and what its entry has to hash to.
struct CaptureRow {
  std::int64_t number = 0;    // from 1 without gaps; the folder evidence/000001
  std::int64_t check_id = 0;  // the check it was made with
  std::string entry_sha256;   // of its entry.json
  std::string signer;         // public key, hexadecimal; "" unsigned
  double wall_s = 0;          // since 1970, UTC; also the modification time of entry.json
};

}  // namespace spool::job
