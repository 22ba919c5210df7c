// The keyboard on the glass: which keys there are and where they stand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/keyboard.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace spool::ui {

namespace {

constexpr int kColumns = 10;
constexpr double kGapDp = 2;
constexpr double kTallestDp = 92;  // keys do not grow beyond this with the screen

Key letter(char32_t c) { return {KeyRole::kLetter, c, utf8(c), "Key " + utf8(c), 1, {}}; }

// What a capital is of, among the letters on the keys.
char32_t upper(char32_t c) {
  if (c >= U'a' && c <= U'z') return c - 0x20;
  if (c >= 0xE0 && c <= 0xFE && c != 0xF7) return c - 0x20;  // à to þ without ÷
  return c == U'œ' ? U'Œ' : c;
}

void add(std::vector<Key>& row, std::u32string_view letters, bool is_shifted) {
  for (const char32_t c : letters) row.push_back(letter(is_shifted ? upper(c) : c));
}

std::vector<Key> last_row(KeyPage page) {
  std::vector<Key> row;
  const auto turn = [&](KeyPage to, KeyRole role, const char* label, const char* name) {
    if (page != to) row.push_back({role, 0, label, name, 1, {}});
  };
  turn(KeyPage::kLetters, KeyRole::kLettersPage, "abc", "Key letters");
  turn(KeyPage::kDigits, KeyRole::kDigitsPage, "123", "Key digits");
  turn(KeyPage::kAccents, KeyRole::kAccentsPage, "éñ", "Key accents");
  row.push_back(letter(U','));
  row.push_back({KeyRole::kLetter, U' ', "space", "Key space", 3, {}});
  row.push_back(letter(U'.'));
  row.push_back({KeyRole::kCancel, 0, "Cancel", "Cancel", 1, {}});
  row.push_back({KeyRole::kDone, 0, "Done", "Done", 2, {}});
  return row;
}

std::vector<std::vector<Key>> rows_of(KeyPage page, bool is_shifted) {
  static constexpr std::u32string_view kRows[3][3] = {{U"qwertyuiop", U"asdfghjkl'", U"zxcvbnm-"},
                                                      {U"1234567890", U"/:()#+°\"&@", U"±=%_;!?*"},
                                                      {U"éèêëàâäáùû", U"üúôöòóîïíì", U"çñßåøæœã"}};
  const auto& letters = kRows[static_cast<int>(page)];
  std::vector<std::vector<Key>> rows(3);
  add(rows[0], letters[0], is_shifted);
  add(rows[1], letters[1], is_shifted);
  rows[2].push_back({KeyRole::kShift, 0, "↑", "Key shift", 1, {}});
  add(rows[2], letters[2], is_shifted);
  rows[2].push_back({KeyRole::kBackspace, 0, "←", "Key back", 1, {}});
  rows.push_back(last_row(page));
  return rows;
}

}  // namespace

std::string utf8(char32_t c) {
  std::string out;
  const auto byte = [&](char32_t bits) {
    out += static_cast<char>(static_cast<unsigned char>(bits));
  };
  if (c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF)) return out;
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0U | (c >> 6U));
    byte(0x80U | (c & 0x3FU));
  } else if (c < 0x10000) {
    byte(0xE0U | (c >> 12U));
    byte(0x80U | ((c >> 6U) & 0x3FU));
    byte(0x80U | (c & 0x3FU));
  } else {
    byte(0xF0U | (c >> 18U));
    byte(0x80U | ((c >> 12U) & 0x3FU));
    byte(0x80U | ((c >> 6U) & 0x3FU));
    byte(0x80U | (c & 0x3FU));
  }
  return out;
}

void drop_last_letter(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U)
    text.pop_back();
  if (!text.empty()) text.pop_back();
}

std::vector<Key> lay_out_keys(const Rect& window, double dp, KeyPage page, bool is_shifted) {
  std::vector<std::vector<Key>> rows = rows_of(page, is_shifted);
  const double gap = kGapDp * dp, target = kTargetDp * dp;
  int columns = kColumns;
  if (window.width < kColumns * target + (kColumns + 1) * gap) {
    columns = std::max(3, static_cast<int>((window.width - gap) / (target + gap)));
    std::vector<std::vector<Key>> narrow(1);
    int used = 0;
    for (const std::vector<Key>& row : rows)
      for (Key key : row) {
        key.width = std::min(key.width, 2);
        if (used + key.width > columns) {
          narrow.emplace_back();
          used = 0;
        }
        used += key.width;
        narrow.back().push_back(std::move(key));
      }
    rows = std::move(narrow);
  }
  const auto count = static_cast<double>(rows.size());
  // Above the keys the text keeps a target's height.
  const double room = (window.height - target - (count + 1) * gap) / count;
  const double height = std::floor(std::clamp(room, target, std::max(target, kTallestDp * dp)));
  const double width = (window.width - gap) / columns;  // with the gap after it
  double y = window.y + window.height - count * (height + gap);
  std::vector<Key> keys;
  for (std::vector<Key>& row : rows) {
    double x = window.x + gap;
    for (Key& key : row) {
      key.rect = {x, y, key.width * width - gap, height};
      x += key.width * width;
      keys.push_back(std::move(key));
    }
    y += height + gap;
  }
  return keys;
}

}  // namespace spool::ui
