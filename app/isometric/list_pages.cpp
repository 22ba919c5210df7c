// The pages after the drawing: the cut sheet, and the weld map with its fields to fill in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/list_pages.h"

#include <algorithm>

#include "app/isometric/page_parts.h"

namespace spool::isometric {
namespace {

constexpr TableStyle kRows{6.4, 2.5, 0};  // room to write by hand
constexpr double kTop_mm = 12;
constexpr double kLeft_mm = kMargin_mm + 4;

std::size_t rows_a_page() {
  const double room = kPageHeight_mm - kMargin_mm - kBlockHeight_mm - 4 - kTop_mm;
  return static_cast<std::size_t>(room / kRows.row_mm - 2.2);
}

int pages_for(std::size_t rows) {
  return static_cast<int>(std::max<std::size_t>(1, (rows + rows_a_page() - 1) / rows_a_page()));
}

std::vector<std::vector<std::string>> part_of(const std::vector<std::vector<std::string>>& rows,
                                              int index) {
  const std::size_t from = std::min(rows.size(), static_cast<std::size_t>(index) * rows_a_page());
  const std::size_t to = std::min(rows.size(), from + rows_a_page());
  return {rows.begin() + static_cast<std::ptrdiff_t>(from),
          rows.begin() + static_cast<std::ptrdiff_t>(to)};
}

void note(PageCanvas& page, const std::vector<std::string>& lines) {
  double y = kPageHeight_mm - kMargin_mm - kBlockHeight_mm + 5;
  for (const std::string& each : lines) {
    page.text(each, kLeft_mm, y, 2.3, TextAlign::kLeft, false,
              kPageWidth_mm - 2 * kMargin_mm - kBlockWidth_mm - 8);
    y += 4.6;
  }
}

WeldState state_of(const Sheet& sheet, const std::string& weld) {
  for (const WeldState& each : sheet.options.states)
    if (each.weld == weld) return each;
  return {weld, WeldStage::kToDo, "", ""};
}

}  // namespace

int cut_page_count(const Sheet& sheet) { return pages_for(sheet.cuts.size()); }
int weld_page_count(const Sheet& sheet) { return pages_for(sheet.welds.size()); }

void draw_cut_page(PageCanvas& page, const Sheet& sheet, int index, int number, int count) {
  draw_frame(page, title_block(sheet, "Cut sheet"), number, count);
  std::vector<std::vector<std::string>> rows;
  for (const guide::CutRow& each : sheet.cuts)
    rows.push_back({each.piece, each.nps, each.schedule,
                    length_of(each.centre_to_centre_m, sheet.options),
                    length_of(each.take_off_m, sheet.options), length_of(each.gap_m, sheet.options),
                    length_of(each.cut_m, sheet.options), each.heat, "", "", ""});
  const TextAlign right = TextAlign::kRight;
  draw_table(page, kLeft_mm, kTop_mm, "Cut sheet",
             {{"Piece", 40},
              {"NPS", 20},
              {"Schedule", 24},
              {"To centres", 34, right},
              {"Less take-offs", 34, right},
              {"Less gaps", 26, right},
              {"Cut length", 36, right},
              {"Heat", 48},
              {"Sawn", 36},
              {"Bevelled", 36},
              {"Measured", 58}},
             part_of(rows, index), kRows);
  note(page,
       {"Cut length = length to centres less the take-offs of both neighbours less root gaps.",
        "A butt weld between two pipes takes half its gap off each."});
}

void draw_weld_page(PageCanvas& page, const Sheet& sheet, int index, int number, int count) {
  draw_frame(page, title_block(sheet, "Weld map"), number, count);
  std::vector<const guide::WeldRow*> in_turn;
  for (const guide::WeldRow& each : sheet.welds) in_turn.push_back(&each);
  std::stable_sort(in_turn.begin(), in_turn.end(),
                   [](const auto* a, const auto* b) { return a->turn < b->turn; });
  std::vector<std::vector<std::string>> rows;
  for (const guide::WeldRow* each : in_turn) {
    const WeldState state = state_of(sheet, each->number);
    const char* type = each->type == JointType::kFab     ? "shop"
                       : each->type == JointType::kField ? "site FW"
                                                         : "yard YAW";
    const std::string signed_by =
        state.fit_up_by + (state.fit_up_on.empty() ? "" : " " + state.fit_up_on);
    rows.push_back({std::to_string(each->turn), each->number, type, each->nps, each->schedule,
                    each->between, each->can_roll ? "roll" : "in place: " + each->why_not,
                    std::string(name(state.stage)), signed_by, "", "", each->heat_a, each->heat_b});
  }
  draw_table(page, kLeft_mm, kTop_mm, "Weld map, in the order of welding",
             {{"Turn", 11},
              {"Weld", 19},
              {"Type", 20},
              {"NPS", 12},
              {"Sch", 12},
              {"Between", 46},
              {"Made", 78},
              {"State", 19},
              {"HOLD: fit-up signed", 46},
              {"Welder", 30},
              {"WPS", 33},
              {"Heat, first", 35},
              {"Heat, second", 35}},
             part_of(rows, index), kRows);
  const guide::RollRules& rules = sheet.options.rolls;
  note(page,
       {"HOLD POINT: no weld before its fit-up is signed off in this row.",
        "Turn: the order that keeps " + std::to_string(sheet.rolled) + " of " +
            std::to_string(sheet.welds.size()) + " welds on rolls" +
            (sheet.plan_is_best ? "; no other order keeps more."
                                : "; with so many welds not all orders were tried."),
        "A weld rolls where a flange on its axis, or a pipe of " +
            length_of(rules.least_grip_m, sheet.options) +
            " or more, can be turned, and all that is",
        "joined to it by then stays within " + length_of(rules.swing_radius_m, sheet.options) +
            " of the axis. Groups are welded by themselves, then joined.",
        "Weights are not looked at. Branch welds on a pipe's side, site and yard welds are made in "
        "place."});
}

}  // namespace spool::isometric
