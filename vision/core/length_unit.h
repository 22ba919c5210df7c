// The units a file may be in, and their metres.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace spool {

enum class LengthUnit { kMetre, kMillimetre, kInch };

// Metres in one unit.
[[nodiscard]] double metres(LengthUnit unit);

// "m", "mm" or "in".
[[nodiscard]] std::string_view name(LengthUnit unit);

// The unit of a flag's value; nothing for any other text.
[[nodiscard]] std::optional<LengthUnit> parse_length_unit(std::string_view text);

}  // namespace spool
