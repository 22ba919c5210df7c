// The isometric's pages: line drawing, shaded view, cut sheet, weld map.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/sheet.h"

#include <cmath>
#include <filesystem>

#include "app/common/length_text.h"
#include "app/isometric/drawing_pages.h"
#include "app/isometric/list_pages.h"
#include "app/isometric/model_view.h"

namespace spool::isometric {
namespace {

void warn_of_missing(int count, const char* where, Sheet& sheet) {
  if (count > 0)
    sheet.warnings.push_back(std::to_string(count) + " labels have no room on " + where +
                             "; convert one spool at a time (--spool)");
}

}  // namespace

std::string length_of(double length_m, const SheetOptions& options) {
  if (options.feet_inches) return length_text(length_m, LengthStyle::kFeetInch);
  return std::to_string(std::llround(1000 * length_m));
}

Result<Sheet> make_sheet(const DesignModel& design, const SheetOptions& options) {
  guide::IsometricOptions how;
  how.area = line_area();
  how.length_text = [&](double length) { return length_of(length, options); };
  how.text_width_mm = text_width_mm;
  Result<guide::Isometric> drawing = guide::draw_isometric(design, how);
  if (!drawing) return drawing.error();
  Sheet sheet;
  sheet.line = design.line;
  sheet.spool = design.spool;
  sheet.revision = design.revision;
  sheet.source = std::filesystem::path(design.path).filename().string();
  sheet.source_sha256 = design.sha256;
  sheet.title = "Isometric " + (design.spool.empty() ? sheet.source : design.spool);
  sheet.options = options;
  sheet.drawing = std::move(*drawing);
  sheet.cuts = guide::cut_rows(design, options.gaps);
  sheet.material = guide::material_rows(design, options.gaps);
  const guide::RollPlan plan = guide::plan_roll_welds(design, options.rolls);
  sheet.welds = guide::weld_rows(design, plan);
  sheet.rolled = plan.rolled;
  sheet.plan_is_best = plan.is_best;
  sheet.picture = draw_model_view(design, sheet.drawing.quarter, how);
  if (!sheet.picture.why_none.empty()) sheet.warnings.push_back(sheet.picture.why_none);
  warn_of_missing(sheet.drawing.labels_without_place, "the line drawing", sheet);
  warn_of_missing(sheet.picture.labels_without_place, "the shaded view", sheet);
  return sheet;
}

TitleBlock title_block(const Sheet& sheet, const std::string& content) {
  return {sheet.line,   sheet.revision,
          sheet.spool,  sheet.options.date,
          content,      sheet.options.feet_inches ? "feet and inches" : "millimetres",
          sheet.source, sheet.source_sha256};
}

Pages pages_of(const Sheet& sheet) {
  const int cuts = cut_page_count(sheet), welds = weld_page_count(sheet);
  const int count = 2 + cuts + welds;
  Pages pages;
  pages.emplace_back([&sheet, count](PageCanvas& page) { draw_line_page(page, sheet, count); });
  pages.emplace_back([&sheet, count](PageCanvas& page) { draw_model_page(page, sheet, count); });
  for (int k = 0; k < cuts; ++k)
    pages.emplace_back(
        [&sheet, count, k](PageCanvas& page) { draw_cut_page(page, sheet, k, 3 + k, count); });
  for (int k = 0; k < welds; ++k)
    pages.emplace_back([&sheet, count, k, cuts](PageCanvas& page) {
      draw_weld_page(page, sheet, k, 3 + cuts + k, count);
    });
  return pages;
}

Result<std::vector<std::string>> write_sheet(const Sheet& sheet, const std::string& path) {
  return write_pages(pages_of(sheet), sheet.title, path);
}

}  // namespace spool::isometric
