// The isometric's pages: line drawing, shaded view, cut sheet, weld map.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/isometric/page_canvas.h"
#include "app/isometric/page_parts.h"
#include "app/isometric/weld_states.h"
#include "vision/core/result.h"
#include "vision/guide/isometric.h"
#include "vision/guide/spool_lists.h"

namespace spool::isometric {

struct SheetOptions {
  guide::GapPolicy gaps;
  guide::RollRules rolls;
  std::string date;               // as it is to stand on the sheet; "" leaves the field empty
  bool feet_inches = false;       // lengths; else whole millimetres
  std::vector<WeldState> states;  // of a job; a weld that is not in it is to do
};

// The shaded view with its labels, or why there is none.
struct ModelPicture {
  render::Image image;
  std::vector<guide::IsometricLabel> labels;  // mm on the page
  std::string why_none;                       // one sentence; "" there is one
  int labels_without_place = 0;
};

struct Sheet {
  std::string title, line, spool, revision, source, source_sha256;
  SheetOptions options;
  guide::Isometric drawing;
  ModelPicture picture;
  std::vector<guide::CutRow> cuts;
  std::vector<guide::MaterialRow> material;
  std::vector<guide::WeldRow> welds;
  int rolled = 0;                     // welds that the plan rolls
  bool plan_is_best = true;           // RollPlan::is_best
  std::vector<std::string> warnings;  // one sentence each
};

// Lays everything out. kBadInput where the design does not say what its parts are. Without a
// graphics driver there is a sheet without its shaded view, and a warning. GL thread, no context
// needed; the driver's own is made for the picture.
[[nodiscard]] Result<Sheet> make_sheet(const DesignModel& design, const SheetOptions& options);

// The pages in order: line drawing, shaded view, cut sheet, weld map. `sheet` has to outlive them.
[[nodiscard]] Pages pages_of(const Sheet& sheet);

// A length (m) as the sheet writes it: whole millimetres, or feet, inches and sixteenths.
[[nodiscard]] std::string length_of(double length_m, const SheetOptions& options);

// The sheet's title block on a page with this content.
[[nodiscard]] TitleBlock title_block(const Sheet& sheet, const std::string& content);

// Writes `path`: one PDF, or of NAME.png the pages NAME-1.png, NAME-2.png ... Each file whole or
// not at all; gives their names. kUsage: another ending; kIo: a file cannot be written.
[[nodiscard]] Result<std::vector<std::string>> write_sheet(const Sheet& sheet,
                                                           const std::string& path);

}  // namespace spool::isometric
