// A text that is being typed, on the glass or on a real keyboard.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "app/ui/evidence_state.h"
#include "app/ui/key_press.h"
#include "app/ui/keyboard.h"

namespace spool {

struct TypingAsk {
  std::string label, help;
  std::string text;              // what is there already
  std::size_t most_bytes = 400;  // of UTF-8; what is beyond is refused and said
  bool many_lines = false;       // Enter begins a line; else it ends the text
};

// Letters go to the end of the text. Valid UTF-8 without control letters stays so.
class TypingSession {
 public:
  enum class End { kNone, kDone, kCancelled };

  void start(TypingAsk ask);
  void type(char32_t letter);
  [[nodiscard]] End press(ui::KeyRole role);
  [[nodiscard]] End press(const ui::KeyPress& key);
  // Without blanks at both ends.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] ui::TypingState state() const;

 private:
  TypingAsk ask_;
  ui::KeyPage page_ = ui::KeyPage::kLetters;
  bool is_shifted_ = false, is_full_ = false;
};

}  // namespace spool
