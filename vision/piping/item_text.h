// Schedule and pressure class out of the free text of a material list, where they mostly live.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace spool::piping {

// "40", "80S", "STD", "XS", "XXS" of "PIPE SMLS SCH 40", "ELBOW S-STD"; "" where there is none. Of
// a reducer's two ("SCH 40 X SCH 80") the first.
[[nodiscard]] std::string schedule_in(std::string_view text);

// "150" of "FLANGE WN RF CL150", "CLASS 150", "150#", "150 LB", "ANSI 150"; "" where there is none.
[[nodiscard]] std::string rating_in(std::string_view text);

}  // namespace spool::piping
