// A page of paper to draw on: PDF as vectors, or PNG of the same page.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/image.h"
#include "vision/core/result.h"
#include "vision/guide/drawing.h"

namespace spool::isometric {

inline constexpr double kPageWidth_mm = 420, kPageHeight_mm = 297;  // A3 landscape, ISO 216

struct PageSize {
  double width_mm = kPageWidth_mm, height_mm = kPageHeight_mm;
};

enum class TextAlign { kLeft, kCentre, kRight };

// One page at a time, millimetres, y down. One thread.
class PageCanvas {
 public:
  PageCanvas(PageCanvas&&) noexcept;
  PageCanvas& operator=(PageCanvas&&) noexcept;
  ~PageCanvas();

  void stroke(const guide::Stroke& stroke);
  void line(double x0, double y0, double x1, double y1, double width_mm);
  void box(double x, double y, double width, double height, double width_mm);
  // One line; `y` is the middle of the letters' height. Longer than `room_mm` (over 0): cut, with
  // an ellipsis.
  void text(const std::string& utf8, double x, double y, double height_mm,
            TextAlign align = TextAlign::kLeft, bool is_bold = false, double room_mm = 0);
  void draw(const guide::Drawing& drawing);
  // Fills a box of the page.
  void image(const render::Image& image, double x, double y, double width, double height);

  // The width (mm) that text() takes.
  [[nodiscard]] double text_width(const std::string& utf8, double height_mm, bool is_bold = false);

 private:
  friend Result<std::string> draw_pdf(const std::vector<std::function<void(PageCanvas&)>>& pages,
                                      const std::string& title, const PageSize& size);
  friend Result<render::Image> draw_page(const std::function<void(PageCanvas&)>& page, double dpi,
                                         const PageSize& size);
  friend double text_width_mm(const std::string& utf8, double height_mm);
  friend std::vector<std::string> wrapped_lines(const std::string& utf8, double height_mm,
                                                double room_mm, bool is_bold);
  struct Impl;
  explicit PageCanvas(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

using Pages = std::vector<std::function<void(PageCanvas&)>>;

// The bytes of a PDF. No clock is read, so that equal sheets are equal files. kInternal where cairo
// fails.
[[nodiscard]] Result<std::string> draw_pdf(const Pages& pages, const std::string& title,
                                           const PageSize& size = {});

// A page as a picture.
[[nodiscard]] Result<render::Image> draw_page(const std::function<void(PageCanvas&)>& page,
                                              double dpi, const PageSize& size = {});

// Writes `path`: one PDF, or of NAME.png the pages NAME-1.png, NAME-2.png ... at 200 dpi. Each file
// whole or not at all; gives their names. kUsage: another ending; kIo: a file cannot be written.
[[nodiscard]] Result<std::vector<std::string>> write_pages(const Pages& pages,
                                                           const std::string& title,
                                                           const std::string& path);

// The width (mm) of a text on any page; for laying out before one is drawn.
[[nodiscard]] double text_width_mm(const std::string& utf8, double height_mm);

// The lines that a text takes in `room_mm`: broken between words, in a word that is longer than the
// room, and where the text has line ends. An empty text is no line.
[[nodiscard]] std::vector<std::string> wrapped_lines(const std::string& utf8, double height_mm,
                                                     double room_mm, bool is_bold = false);

}  // namespace spool::isometric
