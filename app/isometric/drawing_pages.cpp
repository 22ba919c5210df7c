// The two facing pages of a sheet: the line drawing with its lists, and the shaded view.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/drawing_pages.h"

#include <algorithm>
#include <cmath>

#include "app/isometric/model_view.h"
#include "app/isometric/page_parts.h"
#include "vision/guide/isometric_symbols.h"

namespace spool::isometric {
namespace {

constexpr double kLetters_mm = 2.5;

void draw_legend(PageCanvas& page, const Sheet& sheet, double x, double y) {
  guide::Drawing drawing;
  guide::draw_north(sheet.drawing.quarter, {x + 15, y + 15}, drawing);
  const std::pair<JointType, const char*> marks[] = {{JointType::kFab, "shop weld"},
                                                     {JointType::kField, "site weld (FW)"},
                                                     {JointType::kYaw, "yard weld (YAW)"}};
  double at = y + 4;
  for (const auto& [type, text] : marks) {
    for (guide::Stroke& each : guide::weld_mark(type, {x + 40, at}, 1))
      drawing.strokes.push_back(std::move(each));
    page.text(text, x + 44, at, 2.2);
    at += 4.5;
  }
  const auto sample = [&](guide::LabelKind kind, const char* text, const char* meaning) {
    guide::IsometricLabel label;
    label.label.kind = kind;
    label.label.text = text;
    label.placed.is_placed = true;
    label.placed.box = {Eigen::Vector2d(x + 36, at - 1.8), Eigen::Vector2d(x + 44, at + 1.8)};
    guide::draw_label(label, 2.0, drawing);
    page.text(meaning, x + 46, at, 2.2);
    at += 4.8;
  };
  sample(guide::LabelKind::kWeld, "W1", "number of a weld");
  sample(guide::LabelKind::kPart, "pipe-1", "part, as on the screen and in reports");
  page.text("Not to scale. Lengths are between centres, faces and ends as filed;", x + 1, y + 32.5,
            2.0);
  page.text("hatched: a leg along none of east, north and up, with its travel.", x + 1, y + 36,
            2.0);
  page.draw(drawing);
}

std::string gap_text(const Sheet& sheet) {
  const guide::GapPolicy& gaps = sheet.options.gaps;
  if (gaps.rule == guide::GapRule::kSubtract)
    return "root gap " + length_of(gaps.root_gap_m, sheet.options) + " taken off";
  if (gaps.rule == guide::GapRule::kModelHasGaps) return "root gaps as drawn";
  return "no root gap taken off";
}

// Welds in two columns of a table, down and then across.
std::vector<std::vector<std::string>> weld_cells(const Sheet& sheet) {
  std::vector<std::vector<std::string>> rows((sheet.welds.size() + 1) / 2);
  for (std::size_t w = 0; w < sheet.welds.size(); ++w) {
    const guide::WeldRow& weld = sheet.welds[w];
    const char* mark = weld.type == JointType::kFab     ? "fab"
                       : weld.type == JointType::kField ? "field FW"
                                                        : "YAW";
    auto& row = rows[w % rows.size()];
    for (const std::string& cell :
         {weld.number, std::string(mark), weld.nps, std::string(weld.can_roll ? "roll" : "fixed")})
      row.push_back(cell);
  }
  return rows;
}

}  // namespace

guide::Box2 line_area() {
  return {Eigen::Vector2d(kMargin_mm + 1, kMargin_mm + 1),
          Eigen::Vector2d(kPageWidth_mm - kMargin_mm - kBlockWidth_mm - 2,
                          kPageHeight_mm - kMargin_mm - 1)};
}

void draw_line_page(PageCanvas& page, const Sheet& sheet, int count) {
  draw_frame(page, title_block(sheet, "Isometric, not to scale"), 1, count);
  page.draw(sheet.drawing.drawing);
  const double x = kPageWidth_mm - kMargin_mm - kBlockWidth_mm;
  page.line(x, kMargin_mm, x, kPageHeight_mm - kMargin_mm, 0.35);
  draw_legend(page, sheet, x + 1, kMargin_mm + 2);
  const double bottom = kPageHeight_mm - kMargin_mm - kBlockHeight_mm - 3;
  double y = kMargin_mm + 43;
  // The rows share what room there is, and stay legible: what does not fit is on the next sheets.
  const auto weld_rows_count = static_cast<double>((sheet.welds.size() + 1) / 2);
  const double rows = static_cast<double>(sheet.cuts.size() + sheet.material.size()) +
                      weld_rows_count + 3 * 2.2 + 3;
  TableStyle style;
  style.row_mm = std::clamp((bottom - y) / rows, 3.2, 4.6);
  style.letters_mm = std::min(kLetters_mm, 0.52 * style.row_mm);
  const double lists = bottom - style.row_mm * (weld_rows_count + 3.5);
  style.limit_mm = std::max(lists, y + 40);

  std::vector<std::vector<std::string>> cuts;
  for (const guide::CutRow& each : sheet.cuts)
    cuts.push_back({each.piece, each.nps, each.schedule,
                    length_of(each.centre_to_centre_m, sheet.options),
                    length_of(each.take_off_m, sheet.options), length_of(each.gap_m, sheet.options),
                    length_of(each.cut_m, sheet.options)});
  const TextAlign right = TextAlign::kRight;
  y = draw_table(page, x + 2, y, "Cut list (" + gap_text(sheet) + ")",
                 {{"Piece", 24},
                  {"NPS", 12},
                  {"Sch", 12},
                  {"To centres", 20, right},
                  {"Take-offs", 17, right},
                  {"Gaps", 11, right},
                  {"Cut", 20, right}},
                 cuts, style);
  std::vector<std::vector<std::string>> material;
  for (const guide::MaterialRow& each : sheet.material)
    material.push_back({each.text, each.nps, each.schedule, std::to_string(each.pieces),
                        each.length_m > 0 ? length_of(each.length_m, sheet.options) : ""});
  y = draw_table(
      page, x + 2, y + 0.6 * style.row_mm, "Material",
      {{"Part", 48}, {"NPS", 22}, {"Sch", 14}, {"Pieces", 12, right}, {"Length", 20, right}},
      material, style);
  style.limit_mm = bottom;
  const std::vector<Column> half{{"Weld", 20}, {"Type", 15}, {"NPS", 11}, {"Made", 12}};
  std::vector<Column> columns = half;
  if (sheet.welds.size() > 1) columns.insert(columns.end(), half.begin(), half.end());
  draw_table(page, x + 2, y + 0.6 * style.row_mm, "Welds", columns, weld_cells(sheet), style);
}

void draw_model_page(PageCanvas& page, const Sheet& sheet, int count) {
  const guide::Box2 area = model_area();
  if (sheet.picture.why_none.empty()) {
    page.image(sheet.picture.image, area.min().x(), area.min().y(), area.sizes().x(),
               area.sizes().y());
    guide::Drawing drawing;
    for (const guide::IsometricLabel& each : sheet.picture.labels)
      guide::draw_label(each, kLetters_mm, drawing);
    page.draw(drawing);
  } else {
    page.text(sheet.picture.why_none, area.center().x(), area.center().y(), 3.5, TextAlign::kCentre,
              false, area.sizes().x() - 20);
  }
  guide::Drawing north;
  guide::draw_north(sheet.drawing.quarter,
                    {kMargin_mm + 18, kPageHeight_mm - kMargin_mm - kBlockHeight_mm / 2}, north);
  page.draw(north);
  page.text("Seen from the same side as the line drawing.", kMargin_mm + 40,
            kPageHeight_mm - kMargin_mm - 10, 2.4);
  page.text("Lengths, lists and marks of welds: sheet 1.", kMargin_mm + 40,
            kPageHeight_mm - kMargin_mm - 5.5, 2.4);
  draw_frame(page, title_block(sheet, "The same spool as it will look"), 2, count);
}

}  // namespace spool::isometric
