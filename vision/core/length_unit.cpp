// The units a file may be in, and their metres.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/length_unit.h"

namespace spool {

double metres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMetre:
      return 1.0;
    case LengthUnit::kMillimetre:
      return 1e-3;
    case LengthUnit::kInch:
      return 0.0254;  // exact, by definition
  }
  return 1.0;
}

std::string_view name(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMetre:
      return "m";
    case LengthUnit::kMillimetre:
      return "mm";
    case LengthUnit::kInch:
      return "in";
  }
  return "m";
}

std::optional<LengthUnit> parse_length_unit(std::string_view text) {
  for (const LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kMillimetre, LengthUnit::kInch})
    if (text == name(unit)) return unit;
  return std::nullopt;
}

}  // namespace spool
