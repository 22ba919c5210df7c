// What several pages have: frame, title block, tables.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/page_parts.h"

#include <algorithm>

namespace spool::isometric {

void draw_frame(PageCanvas& page, const TitleBlock& title, int number, int count) {
  page.box(kMargin_mm, kMargin_mm, kPageWidth_mm - 2 * kMargin_mm, kPageHeight_mm - 2 * kMargin_mm,
           0.5);
  const double x = kPageWidth_mm - kMargin_mm - kBlockWidth_mm;
  const double y = kPageHeight_mm - kMargin_mm - kBlockHeight_mm;
  const guide::Stroke paper{{{x, y},
                             {x + kBlockWidth_mm, y},
                             {x + kBlockWidth_mm, y + kBlockHeight_mm},
                             {x, y + kBlockHeight_mm}},
                            0.5,
                            true,
                            guide::Stroke::Fill::kPaper};
  page.stroke(paper);
  const auto field = [&](const std::string& label, const std::string& value, double left,
                         double top, double width, double letters) {
    page.box(left, top, width, 10, 0.18);
    page.text(label, left + 1.2, top + 2.4, 1.7);
    page.text(value, left + 1.2, top + 6.8, letters, TextAlign::kLeft, true, width - 2.4);
  };
  field("Line", title.line, x, y, 80, 3);
  field("Revision", title.revision, x + 80, y, 20, 3);
  field("Sheet", std::to_string(number) + " of " + std::to_string(count), x + 100, y, 20, 3);
  field("Spool", title.spool, x, y + 10, 80, 3);
  field("Date", title.date, x + 80, y + 10, 40, 2.6);
  field("Content", title.content, x, y + 20, 80, 2.4);
  field("Lengths", title.lengths, x + 80, y + 20, 40, 2.4);
  const std::string hash = title.source_sha256.substr(0, 16);
  field("Drawn by SpoolSight from", title.source + (hash.empty() ? "" : "  SHA-256 " + hash), x,
        y + 30, kBlockWidth_mm, 2.2);
}

double draw_table(PageCanvas& page, double x, double y, const std::string& title,
                  const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows, const TableStyle& style) {
  double width = 0;
  for (const Column& each : columns) width += each.width_mm;
  page.text(title, x, y + 0.5 * style.row_mm, 1.2 * style.letters_mm, TextAlign::kLeft, true);
  double at = y + 1.15 * style.row_mm;
  const double top = at;
  const auto write = [&](const std::vector<std::string>& cells, bool is_bold) {
    double left = x;
    for (std::size_t c = 0; c < columns.size() && c < cells.size(); ++c) {
      const Column& column = columns[c];
      const double from = column.align == TextAlign::kLeft    ? left + 0.8
                          : column.align == TextAlign::kRight ? left + column.width_mm - 0.8
                                                              : left + 0.5 * column.width_mm;
      page.text(cells[c], from, at + 0.5 * style.row_mm, style.letters_mm, column.align, is_bold,
                column.width_mm - 1.4);
      left += column.width_mm;
    }
    at += style.row_mm;
  };
  std::vector<std::string> heads;
  for (const Column& each : columns) heads.push_back(each.title);
  write(heads, true);
  page.line(x, at, x + width, at, 0.35);
  std::size_t fitting = rows.size();
  if (style.limit_mm > 0 && at + style.row_mm * static_cast<double>(rows.size()) > style.limit_mm)
    fitting = static_cast<std::size_t>(std::max(0.0, (style.limit_mm - at) / style.row_mm - 1));
  for (std::size_t r = 0; r < fitting; ++r) {
    write(rows[r], false);
    page.line(x, at, x + width, at, 0.1);
  }
  if (fitting < rows.size()) {
    page.text("and " + std::to_string(rows.size() - fitting) + " more, on the sheets that follow",
              x + 0.8, at + 0.5 * style.row_mm, style.letters_mm);
    at += style.row_mm;
  }
  page.box(x, top, width, at - top, 0.25);
  double left = x;
  for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
    left += columns[c].width_mm;
    page.line(left, top, left, fitting < rows.size() ? at - style.row_mm : at, 0.1);
  }
  return at;
}

}  // namespace spool::isometric
