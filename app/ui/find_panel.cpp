// Find: the bar while it looks, and the choice where the drawing fits in more than one way.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/ui/panels.h"

namespace spool::ui {

void draw_find_bar(const Painter& painter, double share) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = 16 * dp, top = at.y + 10 * dp;
  // Never quite empty: something is being done from the first moment on.
  const float done = std::clamp(static_cast<float>(share), 0.02F, 1.0F) * width;
  list.AddRectFilled({at.x, top}, {at.x + width, top + height}, kButtonColour, 0.5F * height);
  list.AddRectFilled({at.x, top}, {at.x + std::max(done, height), top + height}, kGhostColour,
                     0.5F * height);
  ImGui::Dummy({1, 38 * dp});
}

void draw_choose(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  begin_panel(painter, "card", layout.card);
  ImGui::PushFont(painter.theme.number);
  ImGui::TextUnformatted(state.choice.c_str());
  ImGui::PopFont();
  ImGui::PushFont(painter.theme.body);
  ImGui::PushStyleColor(ImGuiCol_Text, state.hint_is_warning ? kSuspiciousColour : kTextColour);
  ImGui::TextWrapped("%s", state.hint.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PushFont(painter.theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, kDimTextColour);
  const std::string& foot = state.notice.empty() ? state.choice_evidence : state.notice;
  ImGui::TextUnformatted(fitted(foot, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::End();
  if (big_button(painter, "Accept", layout.actions[0], "this one", ButtonLook::kPrimary)) {
    commands.push_back({Action::kAccept});
  }
  if (big_button(painter, "Next", layout.actions[1], state.choice)) {
    commands.push_back({Action::kNext});
  }
  if (big_button(painter, "Cancel", layout.actions[2])) commands.push_back({Action::kCancelFind});
  if (big_button(painter, "Shot", layout.actions[3])) commands.push_back({Action::kShot});
  if (state.detached && big_button(painter, "Camera", layout.actions[4], "view")) {
    commands.push_back({Action::kCameraView});
  }
}

}  // namespace spool::ui
