// Small pieces of the HTML report: escaped text, status badges, embedded pictures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "vision/inspect/inspection.h"

namespace spool::evidence {

// Text from files and people, safe between tags and in quoted attributes; bytes that are no UTF-8
// become U+FFFD, control characters a space.
[[nodiscard]] std::string escaped(std::string_view text);

// RFC 4648.
[[nodiscard]] std::string base64(std::string_view bytes);

// The word that goes with a status, as the screen says it: "OK", "Can't tell", "Out", "Not seen".
[[nodiscard]] std::string_view word(Verdict verdict);

// The outline of a status as inline SVG of `size_px`: shape first, colour second, readable in black
// and white.
[[nodiscard]] std::string status_shape(Verdict verdict, int size_px);

// A table row of two cells; `value` is already HTML.
[[nodiscard]] std::string row(std::string_view label, std::string_view value_html);

// The style sheet and the page up to and including <body>; the title is escaped here.
[[nodiscard]] std::string page_start(std::string_view title);

}  // namespace spool::evidence
