// A key of a real keyboard, as text entry takes it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool::ui {

struct KeyPress {
  enum class Kind { kLetter, kBackspace, kEnter, kEscape };
  Kind kind = Kind::kLetter;
  char32_t letter = 0;  // of kLetter, Unicode
};

}  // namespace spool::ui
