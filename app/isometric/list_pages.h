// The pages after the drawing: the cut sheet, and the weld map with its fields to fill in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/isometric/sheet.h"

namespace spool::isometric {

// How many pages each takes.
[[nodiscard]] int cut_page_count(const Sheet& sheet);
[[nodiscard]] int weld_page_count(const Sheet& sheet);

// Page `index` (from 0) of them, numbered `number` of `count`.
void draw_cut_page(PageCanvas& page, const Sheet& sheet, int index, int number, int count);
void draw_weld_page(PageCanvas& page, const Sheet& sheet, int index, int number, int count);

}  // namespace spool::isometric
