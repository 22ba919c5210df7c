// The strip along the top, and which screen is drawn.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/panels.h"

#include <algorithm>

namespace spool::ui {

namespace {

const char* word(TrackingMark mark) {
  switch (mark) {
    case TrackingMark::kGood:
      return "tracking";
    case TrackingMark::kPoor:
      return "unsure";
    case TrackingMark::kPaused:
      return "paused";
    case TrackingMark::kFrozen:
      return "frozen";
    case TrackingMark::kLost:
      return "lost";
    case TrackingMark::kNone:
      break;
  }
  return "not aligned";
}

}  // namespace

void draw_strip(const ScreenState& state, const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const Rect& rect = painter.layout.strip;
  const auto width = static_cast<float>(rect.width);
  const float middle = 0.5F * static_cast<float>(rect.height);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  begin_panel(painter, "strip", rect);
  ImDrawList& list = *ImGui::GetWindowDrawList();

  // From the right: unit, sensor, tracking; the spool's name has what is left.
  float x = width - 14 * dp;
  const auto put = [&](const std::string& text, ImU32 tint) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    x -= size.x;
    list.AddText({x, middle - 0.5F * size.y}, tint, text.c_str());
  };
  ImGui::PushFont(painter.theme.body);
  put(state.unit, kDimTextColour);
  x -= 18 * dp;
  const float source_room = std::max(0.0F, 0.3F * width);
  put(fitted(state.source, source_room), state.source_is_well ? kDimTextColour : kNotOkColour);
  x -= 18 * dp;
  put(word(state.tracking), kTextColour);
  x -= 16 * dp;
  draw_tracking(list, state.tracking, {x, middle}, 8 * dp);
  x -= 20 * dp;
  const std::string name = state.step.empty() ? state.title : state.title + " · " + state.step;
  const std::string title = fitted(name, std::max(0.0F, x - 16 * dp));
  const ImVec2 size = ImGui::CalcTextSize(title.c_str());
  list.AddText({16 * dp, middle - 0.5F * size.y}, kTextColour, title.c_str());
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopStyleVar();
}

std::vector<Command> draw_screen(const ScreenState& state, const Theme& theme, const Layout& layout,
                                 TargetList& targets) {
  std::vector<Command> commands;
  targets = {};
  const Painter painter{theme, layout, targets};
  if (state.screen != Screen::kTyping) draw_strip(state, painter);
  switch (state.screen) {
    case Screen::kAlign:
      draw_align(state, painter, commands);
      break;
    case Screen::kChoose:
      draw_choose(state, painter, commands);
      break;
    case Screen::kWork:
      draw_work(state, painter, commands);
      break;
    case Screen::kResults:
      draw_results(state, painter, commands);
      break;
    case Screen::kEvidence:
      draw_evidence(state, painter, commands);
      break;
    case Screen::kNcr:
      draw_ncr(state, painter, commands);
      break;
    case Screen::kTyping:
      draw_typing(state, painter, commands);
      break;
  }
  return commands;
}

}  // namespace spool::ui
