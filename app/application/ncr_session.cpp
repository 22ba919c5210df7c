// The form of a non-conformance report while it is filled in on the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/ncr_session.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spool {

namespace {
constexpr std::size_t kMostLine = 400, kMostText = 4000;  // bytes of a field
}  // namespace

void NcrSession::open(std::vector<ncr::FormField> form, ncr::NcrDraft draft) {
  form_ = std::move(form);
  draft_ = std::move(draft);
  page_ = 0;
  // One field that this version does not know, or no longer has, is no reason to lose the others.
  std::erase_if(draft_.fields, [this](const auto& said) {
    return !ncr::write_fields({{said.first, said.second}}, form_);
  });
}

void NcrSession::set(int field, const std::string& text) {
  if (field == kShopField) {
    draft_.shop = text;
    return;
  }
  ncr::FormField& at = form_.at(static_cast<std::size_t>(field));
  at.value = text;
  draft_.fields[at.key] = text;
}

void NcrSession::choose(int field, int choice) {
  const ncr::FormField& at = form_.at(static_cast<std::size_t>(field));
  const std::string& chosen = at.choices.at(static_cast<std::size_t>(choice));
  set(field, at.value == chosen ? "" : chosen);
}

TypingAsk NcrSession::ask(int field) const {
  const ui::FormLine shown = line(field);
  TypingAsk ask{.label = shown.label, .help = "", .text = shown.value};
  if (field == kShopField) {
    ask.help = "letters without accents, digits, . _ -";
    ask.most_bytes = 40;
    return ask;
  }
  const ncr::FormField& at = form_.at(static_cast<std::size_t>(field));
  ask.many_lines = at.kind == ncr::FieldKind::kText;
  ask.most_bytes = ask.many_lines ? kMostText : kMostLine;
  return ask;
}

std::vector<NcrSession::Page> NcrSession::pages(int rows) const {
  std::vector<Page> pages;
  for (const ncr::FormBlock& block : ncr::form_blocks()) {
    std::vector<int> fields;
    if (pages.empty()) fields.push_back(kShopField);
    for (std::size_t i = 0; i < form_.size(); ++i)
      if (form_[i].block == block.key && form_[i].kind != ncr::FieldKind::kSignature &&
          form_[i].source != ncr::FieldSource::kNumber)
        fields.push_back(static_cast<int>(i));
    for (std::size_t from = 0; from < fields.size(); from += static_cast<std::size_t>(rows)) {
      const std::size_t to = std::min(fields.size(), from + static_cast<std::size_t>(rows));
      pages.push_back({block.title,
                       {fields.begin() + static_cast<std::ptrdiff_t>(from),
                        fields.begin() + static_cast<std::ptrdiff_t>(to)}});
    }
  }
  return pages;
}

ui::FormLine NcrSession::line(int field) const {
  ui::FormLine line;
  line.field = field;
  if (field == kShopField) {
    line.label = "Shop (part of the number)";
    line.value = draft_.shop;
    return line;
  }
  const ncr::FormField& at = form_.at(static_cast<std::size_t>(field));
  line.label = at.who.empty() ? at.label : at.who + ": " + at.label;
  line.value = at.value;
  line.choices = at.choices;
  const auto chosen = std::ranges::find(at.choices, at.value);
  if (chosen != at.choices.end()) line.chosen = static_cast<int>(chosen - at.choices.begin());
  return line;
}

void NcrSession::fill(int rows, ui::FormState& out) const {
  if (!is_open()) return;
  const std::vector<Page> all = pages(rows);
  const int last = static_cast<int>(all.size()) - 1;
  const int at = std::clamp(page_, 0, last);  // a screen that was turned has other pages
  const Page& page = all[static_cast<std::size_t>(at)];
  out.title = page.block;
  out.page = fmt::format("{} of {}", at + 1, last + 1);
  out.can_go_back = at > 0;
  out.can_go_on = at < last;
  for (const int field : page.fields) out.lines.push_back(line(field));
}

}  // namespace spool
