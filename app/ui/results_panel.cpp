// The Results screen: rows worst first, the numbers of one; and the readout on the Work card.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/ui/panels.h"

namespace spool::ui {

namespace {

constexpr float kHeadDp = 84;
constexpr float kRowDp = 80;

ImVec2 corner(const Rect& rect) { return {static_cast<float>(rect.x), static_cast<float>(rect.y)}; }

// Which check this is, its status and why.
void draw_head(const ResultsState& results, const Painter& painter, const Rect& rect) {
  const auto dp = static_cast<float>(painter.theme.dp);
  begin_panel(painter, "results head", rect);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = corner(rect);
  draw_mark(list, results.overall, {at.x + 28 * dp, at.y + 26 * dp}, 15 * dp);
  const float x = at.x + 54 * dp;
  const float width = static_cast<float>(rect.width) - 54 * dp - 12 * dp;
  float y = draw_lines(list, painter.theme.body, {x, at.y + 8 * dp}, kTextColour,
                       std::string(word(results.overall)) + " · " + results.of, width, 1);
  draw_lines(list, painter.theme.small, {x, y + 3 * dp}, kDimTextColour, results.reason, width, 2);
  ImGui::End();
}

void draw_row(const ResultLine& line, const Painter& painter, ImVec2 at, float width,
              float height) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, at.y + 2 * dp}, {at.x + width, at.y + height - 2 * dp}, kButtonColour,
                     8 * dp);
  draw_mark(list, line.status, {at.x + 26 * dp, at.y + 0.5F * height}, 14 * dp);
  const float x = at.x + 54 * dp, room = width - 54 * dp - 8 * dp;
  const float y = draw_lines(list, painter.theme.body, {x, at.y + 15 * dp}, kTextColour,
                             std::string(word(line.status)) + " · " + line.name, room, 1);
  draw_lines(list, painter.theme.small, {x, y + 5 * dp}, kDimTextColour, line.number, room, 1);
}

void draw_list(const ResultsState& results, const Painter& painter, const Rect& rect,
               std::vector<Command>& commands) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const float height = std::ceil(kRowDp * dp);  // rows stand on whole pixels
  const bool is_dragged = begin_drag_panel(painter, "results list", rect);
  const float width = ImGui::GetContentRegionAvail().x - 8 * dp;  // the mark of where it is
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("row", {width, height}) && !is_dragged)
      commands.push_back({Action::kOpenResult, -1, static_cast<int>(i)});
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) continue;
    // Only what is in sight of the scrolled list can be tapped.
    if (at.y >= rect.y && at.y + height <= rect.y + rect.height)
      painter.targets.targets.push_back({"Row " + std::to_string(i), {at.x, at.y, width, height}});
    draw_row(results.lines[i], painter, at, width, height);
  }
  ImGui::PopStyleVar();
  end_drag_panel(painter, rect);
}

// Mark, number and doubt; what it is of. Returns where it ends.
float draw_number(const ResultDetail& detail, const Painter& painter, ImDrawList& list, ImVec2 at,
                  float width) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const Theme& theme = painter.theme;
  draw_mark(list, detail.status, {at.x + 16 * dp, at.y + 20 * dp}, 15 * dp);
  const std::string number = detail.number.empty() ? word(detail.status) : detail.number;
  const float left = at.x + 42 * dp;
  const float wide = theme.number->CalcTextSizeA(theme.number->FontSize, 1e6F, 0, number.c_str()).x;
  const float end =
      draw_lines(list, theme.number, {left, at.y}, kTextColour, number, width - 42 * dp, 1);
  // Beside the number where there is room, else under it.
  const float room = width - 42 * dp - wide - 12 * dp;
  const float needs =
      theme.small->CalcTextSizeA(theme.small->FontSize, 1e6F, 0, detail.doubt.c_str()).x;
  if (detail.doubt.empty()) return end;
  if (needs <= room) {
    draw_lines(list, theme.small, {left + wide + 12 * dp, at.y + 13 * dp}, kDimTextColour,
               detail.doubt, room, 1);
    return end;
  }
  return draw_lines(list, theme.small, {left, end}, kDimTextColour, detail.doubt, width - 42 * dp,
                    2);
}

void draw_detail(const ResultDetail& detail, const Painter& painter, const Rect& rect) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const Theme& theme = painter.theme;
  static_cast<void>(begin_drag_panel(painter, "result detail", rect));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - 10 * dp;
  constexpr int kAll = 100;  // lines
  float y = draw_number(detail, painter, list, start, width) + 4 * dp;
  y = draw_lines(list, theme.body, {start.x, y}, kTextColour,
                 std::string(word(detail.status)) + " · " + detail.name, width, kAll) +
      8 * dp;
  for (const std::string& text : detail.to_do)
    y = draw_lines(list, theme.body, {start.x, y}, kGhostColour, text, width, kAll) + 4 * dp;
  y += 6 * dp;
  const float left = std::min(0.4F * width, 150 * dp);
  for (const auto& [label, value] : detail.facts) {
    const float under = draw_lines(list, theme.small, {start.x, y + 2 * dp}, kDimTextColour, label,
                                   left - 8 * dp, kAll);
    y = std::max(under, draw_lines(list, theme.body, {start.x + left, y}, kTextColour, value,
                                   width - left, kAll)) +
        5 * dp;
  }
  if (!detail.words.empty())
    y = draw_lines(list, theme.small, {start.x, y + 4 * dp}, kDimTextColour, detail.words, width,
                   kAll);
  ImGui::Dummy({width, y - start.y + 8 * dp});
  end_drag_panel(painter, rect);
}

}  // namespace

void draw_readout(const ScreenState& state, const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ResultDetail& readout = state.readout;
  const Theme& theme = painter.theme;
  float y = draw_number(readout, painter, list, at, width) + 4 * dp;
  y = draw_lines(list, theme.body, {at.x, y}, kTextColour,
                 std::string(word(readout.status)) + " · " + readout.name, width, 1);
  // As many lines as there are above the foot.
  const float foot = static_cast<float>(painter.layout.card.y + painter.layout.card.height) -
                     theme.small->FontSize - 10 * dp;
  y += 3 * dp;
  const int lines = static_cast<int>((foot - y) / theme.body->FontSize);
  if (!readout.to_do.empty() && lines > 0)
    draw_lines(list, theme.body, {at.x, y}, kGhostColour, readout.to_do.front(), width, lines);
}

void draw_results(const ScreenState& state, const Painter& painter,
                  std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  const ResultsState& results = state.results;
  const bool is_open = results.open >= 0;
  if (is_open) {
    draw_detail(results.detail, painter, layout.results);
  } else {
    const double head = kHeadDp * painter.theme.dp;
    const Rect& all = layout.results;
    draw_head(results, painter, {all.x, all.y, all.width, head});
    draw_list(results, painter, {all.x, all.y + head, all.width, all.height - head}, commands);
  }
  if (big_button(painter, "Back", layout.actions[0],
                 is_open && !results.opened_alone ? "to the list" : "to the work",
                 ButtonLook::kPrimary))
    commands.push_back({Action::kBack});
  if (big_button(painter, "Shot", layout.actions[2])) commands.push_back({Action::kShot});
  if (results.view_turned && big_button(painter, "Camera", layout.actions[4], "view"))
    commands.push_back({Action::kCameraView});
}

}  // namespace spool::ui
