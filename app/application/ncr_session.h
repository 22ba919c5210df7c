// The form of a non-conformance report while it is filled in on the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/application/typing_session.h"
#include "app/ncr/form.h"
#include "app/ncr/ncr_draft.h"
#include "app/ui/evidence_state.h"

namespace spool {

// What is shown of a form: all fields that a person may fill in, block by block; the number is
// given, and signatures are made by hand.
class NcrSession {
 public:
  static constexpr int kShopField = -2;  // beside the form: it is part of the number

  // `form` as it was filled in from job and report; what `draft` says stands over that.
  void open(std::vector<ncr::FormField> form, ncr::NcrDraft draft);
  [[nodiscard]] bool is_open() const { return !form_.empty(); }
  void close() { form_.clear(); }

  // What a person said, for the draft and for the report.
  [[nodiscard]] const ncr::NcrDraft& draft() const { return draft_; }
  // `field` as ui::FormLine has it.
  void set(int field, const std::string& text);
  void choose(int field, int choice);  // the same again: none
  [[nodiscard]] TypingAsk ask(int field) const;

  void turn(int pages) { page_ += pages; }
  // Lines of the present page, of which the screen has room for `rows`. A page never holds two
  // blocks.
  void fill(int rows, ui::FormState& out) const;

 private:
  struct Page {
    std::string block;
    std::vector<int> fields;
  };
  [[nodiscard]] std::vector<Page> pages(int rows) const;
  [[nodiscard]] ui::FormLine line(int field) const;

  std::vector<ncr::FormField> form_;
  ncr::NcrDraft draft_;
  int page_ = 0;
};

}  // namespace spool
