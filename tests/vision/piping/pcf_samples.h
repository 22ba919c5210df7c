// Piping Component Files written from the format: a spool with every kind of record, and oddities.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace spool::test {

// Two spools of NPS 3 and 2 with flanges, pipes, elbows of 90 and 45, a reducing tee, a cap, an
// eccentric reducer, a socket olet, an orifice flange with its tap, gasket, bolts, valve, support,
// welds with and without record, a line end and MATERIALS. Not one problem.
[[nodiscard]] std::string spool_pcf();

// `text` with every `from` as `to`; `from` has to be there.
[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);

// The same file by other writers: nothing indented, everything in small letters.
[[nodiscard]] std::string unindented(const std::string& text);
[[nodiscard]] std::string in_small_letters(std::string text);

// The line (from 1) of the first place of `what`, 0 where it is not there.
[[nodiscard]] int line_of(const std::string& text, std::string_view what);

// A file of `components`, which are records, in inches and mm unless `header` says other.
[[nodiscard]] std::string pcf(const std::string& components,
                              const std::string& header = "UNITS-BORE INCH\nUNITS-CO-ORDS MM\n");

}  // namespace spool::test
