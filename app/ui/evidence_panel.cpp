// The Evidence screen: a job's captures newest first, and one of them with its picture and numbers.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "app/ui/panels.h"

namespace spool::ui {

namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// Two lines of text beside a mark, within `rect`.
void draw_line(const Painter& painter, const CaptureLine& line, const Rect& rect) {
  const double dp = painter.theme.dp;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double middle = rect.y + 0.5 * rect.height;
  draw_mark(list, line.status, vec(rect.x + 28 * dp, middle), static_cast<float>(15 * dp));
  const auto room = static_cast<float>(rect.width - 68 * dp);
  ImGui::PushFont(painter.theme.body);
  list.AddText(vec(rect.x + 58 * dp, middle - 26 * dp), kTextColour,
               fitted(line.title + " · " + word(line.status), room).c_str());
  ImGui::PopFont();
  ImGui::PushFont(painter.theme.small);
  list.AddText(vec(rect.x + 58 * dp, middle + 4 * dp), kDimTextColour,
               fitted(line.detail, room).c_str());
  ImGui::PopFont();
}

void draw_title(const Painter& painter, const std::string& text) {
  ImGui::PushFont(painter.theme.body);
  ImGui::TextUnformatted(fitted(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
}

void draw_list(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const EvidenceState& evidence = state.evidence;
  const double dp = painter.theme.dp;
  const Rect& sheet = painter.layout.sheet;
  begin_panel(painter, "sheet", sheet);
  draw_title(painter, evidence.lines.empty() ? state.hint : "Captures " + evidence.page);
  double y = sheet.y + kSheetTitleDp * dp;
  for (const CaptureLine& line : evidence.lines) {
    const Rect row{sheet.x + 4 * dp, y, sheet.width - 8 * dp, kTargetDp * dp};
    ImGui::SetCursorScreenPos(vec(row.x, row.y));
    ImGui::PushID(line.number);
    if (ImGui::InvisibleButton("row", vec(row.width, row.height)))
      commands.push_back({Action::kOpenCapture, -1, line.number});
    painter.targets.targets.push_back({"Capture " + std::to_string(line.number), row});
    ImGui::GetWindowDrawList()->AddRectFilled(
        vec(row.x, row.y), vec(row.x + row.width, row.y + row.height),
        ImGui::IsItemActive() ? kButtonDownColour : kButtonColour, static_cast<float>(8 * dp));
    draw_line(painter, line, row);
    ImGui::PopID();
    y += kRowDp * dp;
  }
  ImGui::End();
}

// The picture keeps its shape; centred in `rect`.
void draw_picture(const EvidenceState& evidence, const Painter& painter, const Rect& rect) {
  if (evidence.picture == 0) {
    ImGui::SetCursorScreenPos(vec(rect.x, rect.y));
    ImGui::PushFont(painter.theme.small);
    ImGui::TextUnformatted(fitted(evidence.picture_words, static_cast<float>(rect.width)).c_str());
    ImGui::PopFont();
    return;
  }
  const double scale =
      std::min(rect.width / evidence.picture_width, rect.height / evidence.picture_height);
  const double width = scale * evidence.picture_width, height = scale * evidence.picture_height;
  const double x = rect.x + 0.5 * (rect.width - width), y = rect.y;
  ImGui::GetWindowDrawList()->AddImage(
      reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(evidence.picture)), vec(x, y),
      vec(x + width, y + height));
}

void draw_numbers(const EvidenceState& evidence, const Painter& painter, const Rect& rect) {
  const double dp = painter.theme.dp, step = 44 * dp;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = painter.theme.small;
  ImGui::PushFont(font);
  double y = rect.y;
  const auto room = static_cast<float>(rect.width - 30 * dp);
  for (const CaptureNumber& number : evidence.numbers) {
    if (y + step > rect.y + rect.height) break;
    draw_mark(list, number.status, vec(rect.x + 12 * dp, y + 18 * dp), static_cast<float>(9 * dp));
    list.AddText(vec(rect.x + 30 * dp, y), kTextColour, fitted(number.text, room).c_str());
    list.AddText(vec(rect.x + 30 * dp, y + 18 * dp), kDimTextColour,
                 fitted(number.name, room).c_str());
    y += step;
  }
  ImGui::PopFont();
}

// The picture beside the numbers, above them in portrait.
void draw_opened(const EvidenceState& evidence, const Painter& painter) {
  const double dp = painter.theme.dp;
  const Rect& sheet = painter.layout.sheet;
  begin_panel(painter, "sheet", sheet);
  const Rect head{sheet.x, sheet.y + 4 * dp, sheet.width, 64 * dp};
  draw_line(painter, evidence.opened.front(), head);
  const double margin = 12 * dp, top = head.y + head.height + 8 * dp;
  const double width = sheet.width - 2 * margin, height = sheet.y + sheet.height - margin - top;
  if (painter.layout.portrait) {
    const double picture = std::min(0.55 * height, width * 5 / 8);
    draw_picture(evidence, painter, {sheet.x + margin, top, width, picture});
    draw_numbers(evidence, painter,
                 {sheet.x + margin, top + picture + margin, width, height - picture - margin});
  } else {
    const double left = std::floor(0.55 * width);
    draw_picture(evidence, painter, {sheet.x + margin, top, left, height});
    draw_numbers(evidence, painter,
                 {sheet.x + 2 * margin + left, top, width - left - margin, height});
  }
  ImGui::End();
}

}  // namespace

void draw_evidence(const ScreenState& state, const Painter& painter,
                   std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  const EvidenceState& evidence = state.evidence;
  if (evidence.opened.empty()) {
    draw_list(state, painter, commands);
    if (evidence.can_go_newer && big_button(painter, "Newer", layout.actions[1]))
      commands.push_back({Action::kTurnPage, -1, -1});
    if (evidence.can_go_older && big_button(painter, "Older", layout.actions[2]))
      commands.push_back({Action::kTurnPage, -1, 1});
  } else {
    draw_opened(evidence, painter);
    if (big_button(painter, "NCR", layout.actions[0], "write one", ButtonLook::kPrimary))
      commands.push_back({Action::kNcr});
  }
  if (big_button(painter, "Back", layout.actions[4])) commands.push_back({Action::kLeave});
}

}  // namespace spool::ui
