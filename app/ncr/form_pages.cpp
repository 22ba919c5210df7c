// The form as boxes on paper: labels, values, check boxes, rooms to write and sign in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/form_pages.h"

#include <algorithm>

#include "app/ncr/ncr_text.h"

namespace spool::ncr {
namespace {

constexpr double kLabelRoom_mm = 4.2, kPad_mm = 1.2;
constexpr double kLineRow_mm = 9, kTextRow_mm = 20, kSignRow_mm = 8.5;
constexpr double kWho_mm = 44;  // what a row of signatures begins with

struct Cell {
  const FormField* field;
  double x, width;
  std::vector<std::string> lines;
  std::size_t next = 0;  // the first line that is not on paper yet
};

double share_of(const FormField& field) {
  if (field.kind == FieldKind::kText) return 1;
  if (field.kind == FieldKind::kChoice) return 1.2;
  if (field.kind == FieldKind::kSignature) return 1.3;
  return field.label == "Date" ? 0.6 : 1;
}

std::vector<Cell> cells_of(const std::vector<const FormField*>& row) {
  const double begin = row.front()->who.empty() ? 0 : kWho_mm;
  double shares = 0;
  for (const FormField* each : row) shares += share_of(*each);
  std::vector<Cell> cells;
  double x = kSide_mm + begin;
  for (const FormField* each : row) {
    const double width = (kWidth_mm - begin) * share_of(*each) / shares;
    Cell cell{each, x, width, {}};
    if (each->kind != FieldKind::kChoice)
      cell.lines = isometric::wrapped_lines(each->value, kBody_mm, width - 2 * kPad_mm);
    cells.push_back(std::move(cell));
    x += width;
  }
  return cells;
}

double least_height(const std::vector<const FormField*>& row) {
  for (const FormField* each : row)
    if (each->kind == FieldKind::kText) return kTextRow_mm;
  return row.front()->who.empty() ? kLineRow_mm : kSignRow_mm;
}

// Boxes with the choices beside each other; a cross in the one that is checked.
void draw_choices(const Cell& cell, double y, PageFlow& flow) {
  constexpr double kBox_mm = 3;
  double x = cell.x + kPad_mm;
  for (const std::string& each : cell.field->choices) {
    flow.box(x, y - 0.5 * kBox_mm, kBox_mm, kBox_mm);
    if (each == cell.field->value)
      flow.text("X", x + 0.5 * kBox_mm, y, kBody_mm, true, isometric::TextAlign::kCentre);
    flow.text(each, x + kBox_mm + 1.2, y, kBody_mm);
    x += kBox_mm + 1.2 + isometric::text_width_mm(each, kBody_mm) + 5;
  }
}

void draw_cell(Cell& cell, double top, double height, bool goes_on, PageFlow& flow) {
  const FormField& field = *cell.field;
  flow.box(cell.x, top, cell.width, height);
  flow.text(field.label + (goes_on ? " (continued)" : ""), cell.x + kPad_mm, top + 2.2, kLabel_mm);
  if (field.value.empty() && field.kind != FieldKind::kSignature)
    flow.text(std::string(kToFillIn), cell.x + cell.width - kPad_mm, top + 2.2, 1.4, false,
              isometric::TextAlign::kRight);
  if (field.kind == FieldKind::kChoice) {
    draw_choices(cell, top + kLabelRoom_mm + 1.8, flow);
    return;
  }
  double y = top + kLabelRoom_mm;
  while (cell.next < cell.lines.size() && y + line_mm(kBody_mm) <= top + height + 0.01) {
    flow.text(cell.lines[cell.next++], cell.x + kPad_mm, y + 0.5 * line_mm(kBody_mm), kBody_mm);
    y += line_mm(kBody_mm);
  }
}

void lay_out_row(const std::vector<const FormField*>& row, PageFlow& flow) {
  std::vector<Cell> cells = cells_of(row);
  for (bool goes_on = false;; goes_on = true) {
    std::size_t most = 0;
    for (const Cell& each : cells) most = std::max(most, each.lines.size() - each.next);
    double height = std::max(goes_on ? 0.0 : least_height(row),
                             kLabelRoom_mm + static_cast<double>(most) * line_mm(kBody_mm) + 1);
    // A row goes to the next page whole, unless it is a long text: that fills this one first.
    const bool is_long = height > 60 && flow.left() > 40;
    if (!is_long) flow.need(height);
    const double whole = height;
    height = std::min(height, flow.left());
    const double top = flow.y();
    if (!row.front()->who.empty()) {
      flow.box(kSide_mm, top, kWho_mm, height);
      flow.text(row.front()->who, kSide_mm + kPad_mm, top + 0.5 * height, kSmall_mm, true);
    }
    for (Cell& each : cells)
      if (!goes_on || each.next < each.lines.size()) draw_cell(each, top, height, goes_on, flow);
    flow.skip(height);
    if (height >= whole) return;
    flow.new_page();
  }
}

}  // namespace

void lay_out_form(const NcrDocument& document, PageFlow& flow) {
  flow.text("NON-CONFORMANCE REPORT", kSide_mm, flow.y() + 3, 4.5, true);
  flow.text("SpoolSight", kSide_mm + kWidth_mm, flow.y() + 3, kSmall_mm, false,
            isometric::TextAlign::kRight);
  flow.skip(8.5);
  for (const FormBlock& block : form_blocks()) {
    std::vector<std::vector<const FormField*>> rows;
    int last = -1;
    for (const FormField& each : document.form) {
      if (each.block != block.key) continue;
      if (each.row != last) rows.emplace_back();
      last = each.row;
      rows.back().push_back(&each);
    }
    if (block.key != "head") {
      flow.need(6 + least_height(rows.front()));
      flow.text(block.title, kSide_mm, flow.y() + 2.9, kSmall_mm + 0.3, true);
      flow.skip(5);
    }
    for (const auto& row : rows) lay_out_row(row, flow);
  }
}

}  // namespace spool::ncr
