// Tolerances as data: what a standard, or a shop, allows a dimension, and the clause that says so.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spool {

// Up to and including `up_to` the tolerance is this; the next row takes over beyond.
struct ToleranceStep {
  double up_to = 0;
  double tolerance = 0;  // either way; m or rad
};

// Rows in ascending order. What lies beyond the last one has no tolerance.
struct ToleranceTable {
  std::vector<ToleranceStep> steps;
  std::string clause;  // that results cite

  [[nodiscard]] std::optional<double> at(double value) const;
};

// A flange that is turned about its axis moves its holes along the bolt circle (an arc), and lifts
// one of the two holes that straddle the centreline over the other (a level across them). The
// stricter of both is what holds by either.
enum class RotationReading : std::uint8_t { kStricter, kArc, kLevel };

// Every table may be empty: then nothing of its kind is judged.
struct RuleSet {
  std::string name;
  // Lengths and offsets (m) by nominal pipe size (inches), by nominal length (m), or both: then the
  // one by length counts where the size has no row.
  ToleranceTable length_by_nps, length_by_length;
  // How far (m) a facing or end may be out across its diameter (m), by that diameter …
  ToleranceTable alignment;
  double alignment_slope = 0;  // … and this share of it, where that is more
  // Angles between legs (rad) by the shorter leg's length (m). Empty: as alignment, across the
  // pipe.
  ToleranceTable angle;
  // How far (m) a flange's holes may be turned, by the bolt circle's diameter (m), and how that is
  // measured. Empty: as an angle over the bolt circle's diameter.
  ToleranceTable rotation;
  RotationReading rotation_reading = RotationReading::kStricter;
  // Fitting to fitting with no pipe between (PFI ES-3, 2.4): what each of the two fittings may be
  // off by itself (m) is allowed on top. 0: no exemption.
  double fitting_allowance_m = 0;
};

struct Tolerance {
  double value = 0;  // m or rad, either way
  std::string rule;  // standard and clause
};

// Of a length or offset along a leg of that size (inches; 0: unknown, no row by size is its own).
// `fittings`: 2 where no pipe lies between, else 0.
[[nodiscard]] std::optional<Tolerance> length_tolerance(const RuleSet& rules, double nps,
                                                        double length_m, int fittings = 0);
// Of the tilt (rad) of a face or end of that diameter (m).
[[nodiscard]] std::optional<Tolerance> alignment_tolerance(const RuleSet& rules, double diameter_m);
// Of the angle (rad) between two legs.
[[nodiscard]] std::optional<Tolerance> angle_tolerance(const RuleSet& rules, double shorter_leg_m,
                                                       double diameter_m);
// Of the turn (rad) of a flange with `holes` holes on a circle of that diameter (m).
[[nodiscard]] std::optional<Tolerance> rotation_tolerance(const RuleSet& rules, int holes,
                                                          double bolt_circle_m);

// PFI ES-3 (2009).
[[nodiscard]] RuleSet pfi_es3();
// ISO 13920 with a class for lengths and angles ('A' to 'D') and one for straightness, flatness and
// parallelism ('E' to 'H').
[[nodiscard]] RuleSet iso_13920(char linear, char form);
// "pfi-es3", or "iso-13920-" and both classes of ISO 13920 ("iso-13920-BF"); nothing for any other
// name.
[[nodiscard]] std::optional<RuleSet> standard_rules(std::string_view name);

}  // namespace spool
