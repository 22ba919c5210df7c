// The two facing pages of a sheet: the line drawing with its lists, and the shaded view.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/isometric/sheet.h"

namespace spool::isometric {

// Where the line drawing lies on its page, mm.
[[nodiscard]] guide::Box2 line_area();

void draw_line_page(PageCanvas& page, const Sheet& sheet, int count);   // number 1
void draw_model_page(PageCanvas& page, const Sheet& sheet, int count);  // number 2

}  // namespace spool::isometric
