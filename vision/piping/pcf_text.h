// The lines of a Piping Component File: bytes to text, and what is no such file refused by name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"

namespace spool::piping {

// A line that says something: not blank, no comment.
struct PcfLine {
  int number = 0;       // in the file, from 1
  int indent = 0;       // columns before the text; a tab goes to the next multiple of 4
  std::string keyword;  // capitals, '-' for '_', without the <> that some writers put round it
  std::string value;    // what follows it, trimmed, quotes round the whole taken off
  std::string raw;      // UTF-8, as written
};

struct PcfText {
  std::vector<PcfLine> lines;
  bool was_transcoded = false;  // from CP1252 or UTF-16
};

// Decodes UTF-8 (with or without BOM), UTF-16 with BOM, else CP1252; CR LF, LF or CR. Lines that
// start with '!' or '#' are comments. kBadInput, `name` first: binary pattern files of other trades
// that share the ending, IDF, over-long files.
[[nodiscard]] Result<PcfText> read_pcf_text(std::string_view bytes, const std::string& name);

// ASCII capitals.
[[nodiscard]] std::string to_capitals(std::string_view text);

// Words between blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text);

}  // namespace spool::piping
