// What several pages have: frame, title block, tables.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/isometric/page_canvas.h"

namespace spool::isometric {

inline constexpr double kMargin_mm = 8;
inline constexpr double kBlockWidth_mm = 120, kBlockHeight_mm = 40;  // the title block's

// What the title block says; an empty field stays empty.
struct TitleBlock {
  std::string line, revision, spool, date, content, lengths;
  std::string source, source_sha256;  // the file that the sheet was made from
};

// Frame and, in the lower right corner, the title block.
void draw_frame(PageCanvas& page, const TitleBlock& title, int number, int count);

struct Column {
  std::string title;
  double width_mm = 20;
  TextAlign align = TextAlign::kLeft;
};

struct TableStyle {
  double row_mm = 4.2, letters_mm = 2.0;
  double limit_mm = 0;  // over 0: no row ends below; the last then says how many are left out
};

// Title, heads and rows from (x, y); gives where it ends. Long cells are cut with an ellipsis.
double draw_table(PageCanvas& page, double x, double y, const std::string& title,
                  const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows, const TableStyle& style);

}  // namespace spool::isometric
