// Text, boxes and pictures one below the other over as many A4 pages as they take.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/page_flow.h"

namespace spool::ncr {

using isometric::PageCanvas;
using isometric::TextAlign;

PageFlow::PageFlow(std::string head) : head_(std::move(head)), pages_(1) {}

double PageFlow::left() const { return kA4.height_mm - kBottom_mm - y_; }

void PageFlow::new_page() {
  pages_.emplace_back();
  y_ = kTop_mm;
  text(head_, kSide_mm, y_ + 1.5, kSmall_mm, true);
  y_ += 6;
  is_fresh_ = true;
}

void PageFlow::need(double height_mm) {
  if (left() < height_mm && !is_fresh_) new_page();
}

void PageFlow::draw(Mark mark) {
  pages_.back().push_back(std::move(mark));
  is_fresh_ = false;
}

void PageFlow::text(const std::string& line, double x, double y, double letters_mm, bool is_bold,
                    TextAlign align) {
  draw([=](PageCanvas& page) { page.text(line, x, y, letters_mm, align, is_bold); });
}

void PageFlow::box(double x, double y, double width, double height) {
  draw([=](PageCanvas& page) { page.box(x, y, width, height, 0.2); });
}

void PageFlow::title(const std::string& text) {
  need(22);  // with some of what it is the title of
  if (!is_fresh_) y_ += 3;
  this->text(text, kSide_mm, y_ + 2.5, 3, true);
  const double y = y_ + 5.5;
  draw([y](PageCanvas& page) { page.line(kSide_mm, y, kSide_mm + kWidth_mm, y, 0.35); });
  y_ += 7.5;
}

void PageFlow::paragraph(const std::string& text, double letters_mm) {
  for (const std::string& each : isometric::wrapped_lines(text, letters_mm, kWidth_mm)) {
    need(line_mm(letters_mm));
    this->text(each, kSide_mm, y_ + 0.5 * line_mm(letters_mm), letters_mm);
    y_ += line_mm(letters_mm);
  }
}

isometric::Pages PageFlow::pages(const std::string& foot) const {
  isometric::Pages pages;
  for (std::size_t k = 0; k < pages_.size(); ++k) {
    const std::string number =
        "page " + std::to_string(k + 1) + " of " + std::to_string(pages_.size());
    pages.emplace_back([marks = pages_[k], foot, number](PageCanvas& page) {
      for (const Mark& each : marks) each(page);
      const double y = kA4.height_mm - 8;
      page.line(kSide_mm, y - 2.5, kSide_mm + kWidth_mm, y - 2.5, 0.15);
      page.text(foot, kSide_mm, y, kSmall_mm, TextAlign::kLeft, false, kWidth_mm - 30);
      page.text(number, kSide_mm + kWidth_mm, y, kSmall_mm, TextAlign::kRight);
    });
  }
  return pages;
}

}  // namespace spool::ncr
