// Lines, words and numbers of a text file, whatever the locale.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace spool {

// The number that is all of `text` (also nan and inf, a leading +). One too large for a double is
// NaN, one too small is 0. Nothing for any other text.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

// The decimal count that is all of `text`; nothing where it is negative, no integer or too large.
[[nodiscard]] std::optional<std::uint64_t> parse_count(std::string_view text);

// Cuts the next word (of anything but blanks, tabs and line ends) off `text`; empty at its end.
[[nodiscard]] std::string_view next_word(std::string_view& text);

// Walks through the lines of a text; both kinds of line end.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : rest_(text) {}

  // The next line without its end, or nothing after the last.
  [[nodiscard]] std::optional<std::string_view> next();
  [[nodiscard]] std::size_t line_number() const { return line_; }  // of the last line given, from 1
  [[nodiscard]] std::string_view rest() const { return rest_; }    // what follows it

 private:
  std::string_view rest_;
  std::size_t line_ = 0;
};

}  // namespace spool
