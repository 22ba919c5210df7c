// Text of strangers' files on a terminal: no control characters, one line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace spool::tools {

// Control characters become '?'; all else, accents too, stays.
[[nodiscard]] inline std::string plain_text(std::string text) {
  constexpr char kDelete = 0x7f;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == kDelete) c = '?';
  }
  return text;
}

}  // namespace spool::tools
