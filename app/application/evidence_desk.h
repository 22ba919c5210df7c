// What the Evidence screens are at: the page, the capture that is open, its form, what is typed.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/application/ncr_session.h"
#include "app/application/typing_session.h"
#include "app/ncr/ncr_register.h"
#include "app/ui/screen_state.h"
#include "render/image.h"
#include "render/image_texture.h"
#include "vision/core/result.h"

namespace spool {

// What the journal's thread has to say of a capture.
struct CapturePicture {
  std::int64_t number = 0;
  Result<render::Image> image;
};
struct OpenedForm {
  std::int64_t number = 0;
  Result<std::vector<ncr::FormField>> form;
  ncr::NcrDraft draft;
};
struct WrittenForm {
  std::int64_t number = 0;
  Result<ncr::Issued> issued;
};
struct SavedDraft {
  Status status;
};
using DeskAnswer = std::variant<CapturePicture, OpenedForm, WrittenForm, SavedDraft>;

// The main thread's; `picture` goes before the GL context.
struct EvidenceDesk {
  ui::Screen back_to = ui::Screen::kWork;  // where Evidence was opened from
  int first = 0;                           // of the captures, newest first, that the page shows
  std::int64_t opened = 0;                 // 0: the list
  render::ImageTexture picture;
  std::string picture_words;

  NcrSession form;
  std::map<std::int64_t, ncr::NcrDraft> drafts;  // of this run, by capture
  std::string shop;                              // as last said
  bool is_writing = false;
  std::string said;  // of the form: what was written, or why not
  bool said_warns = false;

  TypingSession typing;
  ui::Screen typing_back = ui::Screen::kWork;
  std::optional<int> typed_field;  // of the form; none: the operator's name
};

}  // namespace spool
