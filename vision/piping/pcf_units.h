// The units of a Piping Component File, and bores read as nominal pipe sizes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spool::piping {

enum class BoreUnit { kInch, kMillimetre, kInchSixteenth };
[[nodiscard]] std::string_view name(BoreUnit unit);

// What UNITS-BORE says; nothing for any other word.
[[nodiscard]] std::optional<BoreUnit> bore_unit_of(std::string_view word);

// Metres in one unit of what UNITS-CO-ORDS says (MM, INCH, MM-HUNDREDTH, METRE ...).
[[nodiscard]] std::optional<double> coordinate_unit_of(std::string_view word);
[[nodiscard]] std::string_view coordinate_unit_name(double metres);

// A bore as written is a nominal size: NPS (inches), DN (mm), or by mistake an outside diameter or
// a nominal size of the other unit, which the note then says.
struct Bore {
  double nps = 0;               // inches; 0: not known
  double outside_diameter = 0;  // m
  std::string note;             // "" where it is as it should be
};
[[nodiscard]] Bore read_bore(double written, BoreUnit unit);

// The unit in which bores are nominal sizes. `declared` unless all of them are sizes of the other
// unit only; where nothing is declared, the one that fits, nothing where both do or none.
[[nodiscard]] std::optional<BoreUnit> settle_bore_unit(std::optional<BoreUnit> declared,
                                                       std::span<const double> bores);

// A length of a fitting as drawn and as the catalogue has it.
struct KnownLength {
  double drawn = 0;  // file units
  double meant = 0;  // m
};
// The unit (m) that makes most of them agree within a third: mm, inch, metre or a hundredth of a
// mm. Nothing where none does.
[[nodiscard]] std::optional<double> guess_coordinate_unit(std::span<const KnownLength> lengths);

}  // namespace spool::piping
