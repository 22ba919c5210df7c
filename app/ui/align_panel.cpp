// The Align screen: find, or three chips, the hint, undo and done.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "app/ui/panels.h"

namespace spool::ui {

namespace {

// A numbered disc and, once three picks stand, how far the pick is off.
float draw_chip(ImDrawList& list, const Theme& theme, const PairChip& chip, int number, ImVec2 at) {
  const auto dp = static_cast<float>(theme.dp);
  const float radius = 17 * dp;
  const ImVec2 centre(at.x + radius, at.y);
  const ImU32 tint = chip.set ? kOkColour : (chip.current ? kGhostColour : kNotMeasuredColour);
  if (chip.set) {
    list.AddCircleFilled(centre, radius, tint, 24);
  } else {
    list.AddCircle(centre, radius, tint, 24, (chip.current ? 3.0F : 1.5F) * dp);
  }
  char text[32];
  std::snprintf(text, sizeof text, "%d", number);
  const ImVec2 size = theme.body->CalcTextSizeA(theme.body->FontSize, 1e6F, 0, text);
  list.AddText(theme.body, theme.body->FontSize,
               {centre.x - 0.5F * size.x, centre.y - 0.5F * size.y},
               chip.set ? IM_COL32(0x10, 0x14, 0x18, 255) : kTextColour, text);
  float width = 2 * radius + 8 * dp;
  if (!chip.residual.empty()) {
    const char* residual = chip.residual.c_str();
    const ImVec2 wide = theme.body->CalcTextSizeA(theme.body->FontSize, 1e6F, 0, residual);
    list.AddText(theme.body, theme.body->FontSize, {at.x + width, centre.y - 0.5F * wide.y},
                 kTextColour, residual);
    width += wide.x;
  }
  return width + 14 * dp;
}

void draw_chips(const ScreenState& state, const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.y += 18 * dp;
  for (std::size_t i = 0; i < state.chips.size(); ++i) {
    at.x += draw_chip(list, painter.theme, state.chips[i], static_cast<int>(i) + 1, at);
  }
  ImGui::Dummy({1, 38 * dp});
}

void draw_label(const Painter& painter, const Rect& view, const char* text) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto dp = static_cast<float>(painter.theme.dp);
  ImFont* font = painter.theme.body;
  const ImVec2 at(static_cast<float>(view.x) + 14 * dp, static_cast<float>(view.y) + 10 * dp);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e6F, 0, text);
  list.AddRectFilled({at.x - 8 * dp, at.y - 4 * dp},
                     {at.x + size.x + 8 * dp, at.y + size.y + 4 * dp}, kPanelColour, 6 * dp);
  list.AddText(font, font->FontSize, at, kTextColour, text);
}

}  // namespace

void draw_align(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  const auto dp = static_cast<float>(painter.theme.dp);
  draw_label(painter, layout.design_view, "Drawing");
  draw_label(painter, layout.scan_view, "Camera");
  // A line between the two pictures.
  ImDrawList& back = *ImGui::GetBackgroundDrawList();
  const Rect& scan = layout.scan_view;
  const ImVec2 corner(static_cast<float>(scan.x), static_cast<float>(scan.y));
  const ImVec2 end = layout.portrait ? ImVec2(static_cast<float>(scan.x + scan.width), corner.y)
                                     : ImVec2(corner.x, static_cast<float>(scan.y + scan.height));
  back.AddLine(corner, end, IM_COL32(255, 255, 255, 90), 2 * dp);

  begin_panel(painter, "card", layout.align_card);
  if (state.finding) {
    draw_find_bar(painter, state.find_share);
  } else {
    draw_chips(state, painter);
  }
  ImGui::PushFont(painter.theme.body);
  ImGui::PushStyleColor(ImGuiCol_Text, state.hint_is_warning ? kSuspiciousColour : kTextColour);
  ImGui::TextWrapped("%s", state.hint.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  if (!state.proposed.empty()) {
    ImGui::PushFont(painter.theme.small);
    ImGui::PushStyleColor(ImGuiCol_Text, kDimTextColour);
    ImGui::TextWrapped("%s", state.proposed.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
  }
  ImGui::End();

  if (state.can_finish &&
      big_button(painter, "Done", layout.actions[0], {}, ButtonLook::kPrimary)) {
    commands.push_back({Action::kFinish});
  }
  // In the place of Done: there is one or the other.
  if (state.can_skip && !state.can_finish &&
      big_button(painter, "Other", layout.actions[0], "point")) {
    commands.push_back({Action::kSkip});
  }
  // Not where Find was: who taps twice does not mean to stop it.
  if (state.finding && big_button(painter, "Cancel", layout.actions[0])) {
    commands.push_back({Action::kCancelFind});
  }
  // In the place of Undo, until there is something to undo.
  if (state.can_find && !state.can_undo &&
      big_button(painter, "Find", layout.actions[1], "the spool", ButtonLook::kPrimary)) {
    commands.push_back({Action::kFind});
  }
  if (state.can_undo && big_button(painter, "Undo", layout.actions[1])) {
    commands.push_back({Action::kUndo});
  }
  if (state.can_go_back && big_button(painter, "Back", layout.actions[2])) {
    commands.push_back({Action::kBack});
  }
  if (!state.can_go_back && big_button(painter, "Box", layout.actions[2], state.box_word)) {
    commands.push_back({Action::kBox});
  }
  if (big_button(painter, "Shot", layout.actions[3])) commands.push_back({Action::kShot});
  if (state.can_replay) {
    if (big_button(painter, "Replay", layout.actions[4])) commands.push_back({Action::kReplay});
    return;
  }
  if (big_button(painter, "More", layout.actions[4], state.menu_open ? "close" : ""))
    commands.push_back({Action::kMenu});
  if (state.menu_open && big_button(painter, "Save", layout.extras[0], "last 10 s"))
    commands.push_back({Action::kSaveLast});
  if (state.menu_open && state.has_evidence &&
      big_button(painter, "Evidence", layout.extras[3], "captures"))
    commands.push_back({Action::kEvidence});
  if (state.menu_open && state.can_go_back &&
      big_button(painter, "Box", layout.extras[1], state.box_word))
    commands.push_back({Action::kBox});
}

}  // namespace spool::ui
