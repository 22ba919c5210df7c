// What the Evidence, NCR and text entry panels read: words ready to be shown.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/ui/status_mark.h"

namespace spool::ui {

enum class KeyPage { kLetters, kDigits, kAccents };

// One capture of the job.
struct CaptureLine {
  int number = 0;
  std::string title;  // "3 · step 2 · elbow_2 · W4"
  StatusMark status = StatusMark::kNotMeasured;
  std::string detail;  // "2026-11-29 12:03 UTC · operator 1 · not signed"
};

struct CaptureNumber {
  StatusMark status = StatusMark::kNotMeasured;
  std::string name, text;  // "face alignment", "+4.6 mm ± 0.7 mm (limit ± 3.0 mm)"
};

struct EvidenceState {
  std::string page;  // "1 to 5 of 12"
  bool can_go_newer = false, can_go_older = false;
  std::vector<CaptureLine> lines;  // newest first, those of the page
  // One of them opened; empty: the list is shown.
  std::vector<CaptureLine> opened;
  std::vector<CaptureNumber> numbers;            // its main ones, worst first
  std::uint64_t picture = 0;                     // texture of its picture; 0: none (yet)
  double picture_width = 0, picture_height = 0;  // px
  std::string picture_words;                     // where there is none: why
};

// A field of the form, or what it needs besides.
struct FormLine {
  int field = -1;
  std::string label, value;
  std::vector<std::string> choices;  // of a choice; else it is typed
  int chosen = -1;
};

struct FormState {
  std::string title;  // "Root cause"
  std::string page;   // "4 of 11"
  std::string foot;   // what is left to do, or what was written
  bool foot_warns = false;
  std::vector<FormLine> lines;  // of the page
  bool can_go_on = false, can_go_back = false;
  bool can_write = false, is_writing = false;
};

struct TypingState {
  std::string label, text;
  std::string help;  // what it is for
  KeyPage page = KeyPage::kLetters;
  bool is_shifted = false;
};

}  // namespace spool::ui
