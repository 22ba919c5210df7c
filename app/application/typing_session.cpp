// A text that is being typed, on the glass or on a real keyboard.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/typing_session.h"

#include <utility>

namespace spool {

void TypingSession::start(TypingAsk ask) {
  ask_ = std::move(ask);
  page_ = ui::KeyPage::kLetters;
  is_shifted_ = ask_.text.empty();
  is_full_ = false;
}

void TypingSession::type(char32_t letter) {
  if ((letter < U' ' && letter != U'\n') || letter == 0x7F) return;
  const std::string bytes = ui::utf8(letter);
  is_full_ = ask_.text.size() + bytes.size() > ask_.most_bytes;
  if (!is_full_) ask_.text += bytes;
  is_shifted_ = false;
}

TypingSession::End TypingSession::press(ui::KeyRole role) {
  switch (role) {
    case ui::KeyRole::kShift:
      is_shifted_ = !is_shifted_;
      break;
    case ui::KeyRole::kBackspace:
      ui::drop_last_letter(ask_.text);
      is_full_ = false;
      break;
    case ui::KeyRole::kLettersPage:
      page_ = ui::KeyPage::kLetters;
      break;
    case ui::KeyRole::kDigitsPage:
      page_ = ui::KeyPage::kDigits;
      break;
    case ui::KeyRole::kAccentsPage:
      page_ = ui::KeyPage::kAccents;
      break;
    case ui::KeyRole::kCancel:
      return End::kCancelled;
    case ui::KeyRole::kDone:
      return End::kDone;
    case ui::KeyRole::kLetter:
      break;
  }
  return End::kNone;
}

TypingSession::End TypingSession::press(const ui::KeyPress& key) {
  switch (key.kind) {
    case ui::KeyPress::Kind::kLetter:
      type(key.letter);
      break;
    case ui::KeyPress::Kind::kBackspace:
      return press(ui::KeyRole::kBackspace);
    case ui::KeyPress::Kind::kEnter:
      if (!ask_.many_lines) return End::kDone;
      type(U'\n');
      break;
    case ui::KeyPress::Kind::kEscape:
      return End::kCancelled;
  }
  return End::kNone;
}

std::string TypingSession::text() const {
  constexpr const char* kBlanks = " \n";
  const auto first = ask_.text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return ask_.text.substr(first, ask_.text.find_last_not_of(kBlanks) - first + 1);
}

ui::TypingState TypingSession::state() const {
  ui::TypingState state;
  state.label = ask_.label;
  state.text = ask_.text;
  state.help = is_full_ ? "no room for more" : ask_.help;
  state.page = page_;
  state.is_shifted = is_shifted_;
  return state;
}

}  // namespace spool
