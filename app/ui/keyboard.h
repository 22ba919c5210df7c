// The keyboard on the glass: which keys there are and where they stand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/ui/layout.h"

namespace spool::ui {

enum class KeyRole {
  kLetter,
  kShift,
  kBackspace,
  kLettersPage,
  kDigitsPage,
  kAccentsPage,
  kCancel,
  kDone
};

struct Key {
  KeyRole role = KeyRole::kLetter;
  char32_t letter = 0;  // of kLetter
  std::string label;    // as it stands on the key
  std::string name;     // of its target: "Key a", "Key space", "Done"
  int width = 1;        // keys
  Rect rect;            // px
};

// All keys of a page within the lower part of a window, four rows of ten; on a window too narrow
// for ten the same keys in as many rows as it takes. Every side is kTargetDp or more.
[[nodiscard]] std::vector<Key> lay_out_keys(const Rect& window, double dp, KeyPage page,
                                            bool is_shifted);

// UTF-8 of a letter; what is none (a surrogate, beyond Unicode) gives nothing.
[[nodiscard]] std::string utf8(char32_t letter);
// Takes the last letter of a UTF-8 text away.
void drop_last_letter(std::string& text);

}  // namespace spool::ui
