// Text, boxes and pictures one below the other over as many A4 pages as they take.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/isometric/page_canvas.h"

namespace spool::ncr {

inline constexpr isometric::PageSize kA4{210, 297};
inline constexpr double kSide_mm = 12, kTop_mm = 12, kBottom_mm = 14;
inline constexpr double kWidth_mm = kA4.width_mm - 2 * kSide_mm;

// Letters' heights, mm.
inline constexpr double kBody_mm = 2.5, kSmall_mm = 2.0, kLabel_mm = 1.7;

// How far lines of letters of a height are apart, mm.
[[nodiscard]] constexpr double line_mm(double letters_mm) { return 1.75 * letters_mm; }

// What is drawn is remembered and drawn when the number of pages is known. Millimetres, y down. One
// thread.
class PageFlow {
 public:
  using Mark = std::function<void(isometric::PageCanvas&)>;

  // `head` is drawn at the top of every page after the first.
  explicit PageFlow(std::string head);

  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double left() const;  // room above the page's bottom
  void skip(double height_mm) { y_ += height_mm; }
  void new_page();
  // A new page unless so much fits on this one (or nothing is on it).
  void need(double height_mm);
  // Something at its place on this page; moves nothing.
  void draw(Mark mark);
  void text(const std::string& line, double x, double y, double letters_mm, bool is_bold = false,
            isometric::TextAlign align = isometric::TextAlign::kLeft);
  void box(double x, double y, double width, double height);

  void title(const std::string& text);                                    // of a section
  void paragraph(const std::string& text, double letters_mm = kBody_mm);  // breaks over pages

  // The pages, each with `foot` and "page 1 of 3" below.
  [[nodiscard]] isometric::Pages pages(const std::string& foot) const;

 private:
  std::string head_;
  std::vector<std::vector<Mark>> pages_;
  double y_ = kTop_mm;
  bool is_fresh_ = true;  // nothing below the head yet
};

}  // namespace spool::ncr
