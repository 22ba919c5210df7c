// The Work screen: the number that decides, the parts worst first, five actions and what More has.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/ui/panels.h"

namespace spool::ui {

namespace {

std::string numbers_of(const PartLine& line) {
  if (line.status == StatusMark::kNotMeasured) return line.seen + " seen";
  // In a row the unit is said once: "+1.2 ± 0.4 mm". Feet and inches have it in each number.
  const std::string unit = " mm";
  const bool is_twice = line.number.ends_with(unit) && line.doubt.ends_with(unit);
  const std::string number =
      is_twice ? line.number.substr(0, line.number.size() - unit.size()) : line.number;
  return number + " " + line.doubt + "   " + line.seen + " seen";
}

void draw_deciding(const ScreenState& state, const Painter& painter, float width) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (!state.measured || state.parts.empty()) {
    ImGui::PushFont(painter.theme.body);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextColored(
        ImGui::ColorConvertU32ToFloat4(state.hint_is_warning ? kSuspiciousColour : kTextColour),
        "%s", state.hint.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    return;
  }
  const PartLine& worst = state.parts.front();
  draw_mark(list, worst.status, {at.x + 16 * dp, at.y + 20 * dp}, 15 * dp);
  ImGui::SetCursorScreenPos({at.x + 42 * dp, at.y});
  const bool is_seen = worst.status != StatusMark::kNotMeasured;
  ImGui::PushFont(painter.theme.number);
  if (is_seen) {
    ImGui::TextUnformatted(worst.number.c_str());
  } else {
    ImGui::TextUnformatted(word(worst.status));
  }
  ImGui::PopFont();
  ImGui::PushFont(painter.theme.body);
  const std::string where = worst.name + ": " + worst.side + " the drawing";
  ImGui::TextUnformatted(fitted(is_seen ? where : worst.name, width).c_str());
  ImGui::PopFont();
  ImGui::PushFont(painter.theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, kDimTextColour);
  const std::string text =
      is_seen ? std::string(word(worst.status)) + " · " + worst.doubt + " · " + worst.seen + " seen"
              : "point noise " + state.point_noise;
  ImGui::TextUnformatted(fitted(text, width).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void draw_rows(const ScreenState& state, const Painter& painter, ImVec2 at, float width, int rows) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = painter.theme.small;
  const float step = font->FontSize + 12 * dp;
  ImGui::PushFont(font);
  for (int i = 0; i < rows && i < static_cast<int>(state.parts.size()); ++i) {
    const PartLine& line = state.parts[static_cast<std::size_t>(i)];
    const float y = at.y + static_cast<float>(i) * step;
    draw_mark(list, line.status, {at.x + 9 * dp, y + 0.5F * font->FontSize}, 8 * dp);
    const std::string numbers = numbers_of(line);
    const float name_width = 0.34F * width;
    list.AddText({at.x + 24 * dp, y}, kTextColour, fitted(line.name, name_width - 30 * dp).c_str());
    list.AddText({at.x + name_width, y}, kDimTextColour,
                 fitted(numbers, width - name_width).c_str());
  }
  ImGui::PopFont();
}

// All parts, each a target of full height; a tap lights the part.
void draw_list(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const double dp = painter.theme.dp;
  const Rect& rect = painter.layout.list;
  const bool is_dragged = begin_drag_panel(painter, "parts", rect);
  for (const PartLine& line : state.parts) {
    ImGui::PushID(line.part);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - static_cast<float>(8 * dp);
    const float height = std::ceil(static_cast<float>(kTargetDp * dp));  // on whole pixels
    if (ImGui::InvisibleButton("row", {width, height}) && !is_dragged) {
      commands.push_back({Action::kLightPart, line.part});
    }
    // Only what is in sight of the scrolled list can be tapped.
    if (at.y >= rect.y && at.y + height <= rect.y + rect.height) {
      painter.targets.targets.push_back({"Part " + line.name, {at.x, at.y, width, height}});
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto d = static_cast<float>(dp);
    if (line.part == state.lit_part) {
      list.AddRectFilled(at, {at.x + width, at.y + height}, IM_COL32(0x56, 0xB4, 0xE9, 60), 8 * d);
    }
    draw_mark(list, line.status, {at.x + 24 * d, at.y + 0.5F * height}, 14 * d);
    const float room = width - 56 * d;
    draw_lines(list, painter.theme.body, {at.x + 52 * d, at.y + 14 * d}, kTextColour,
               line.name + " · " + word(line.status), room, 1);
    draw_lines(list, painter.theme.small, {at.x + 52 * d, at.y + 42 * d}, kDimTextColour,
               numbers_of(line), room, 1);
    ImGui::PopID();
  }
  end_drag_panel(painter, rect);
}

void draw_card(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const Rect& card = painter.layout.card;
  const auto dp = static_cast<float>(painter.theme.dp);
  begin_panel(painter, "card", card);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float inner = ImGui::GetContentRegionAvail().x;
  const bool read_out = state.readout_shown;
  const bool listed = state.measured && !state.parts.empty() && !read_out;
  const float left = listed ? 0.42F * inner : inner;
  if (listed) {
    painter.targets.targets.push_back({"Parts", card});
    if (ImGui::InvisibleButton("toggle", ImGui::GetContentRegionAvail())) {
      commands.push_back({Action::kToggleList});
    }
    ImGui::SetCursorScreenPos(start);
  }
  if (read_out) {
    painter.targets.targets.push_back({"Results", card});
    if (ImGui::InvisibleButton("results", ImGui::GetContentRegionAvail()))
      commands.push_back({Action::kResults});
    ImGui::SetCursorScreenPos(start);
    draw_readout(state, painter);
  } else {
    draw_deciding(state, painter, left - 8 * dp);
  }
  if (listed) draw_rows(state, painter, {start.x + left, start.y + 2 * dp}, inner - left, 3);
  // The foot: what to do, or what just happened.
  const std::string& foot = !state.notice.empty()                ? state.notice
                            : read_out && !state.hint_is_warning ? state.readout_of
                            : listed || read_out                 ? state.hint
                                                                 : state.notice;
  if (!foot.empty()) {
    ImGui::PushFont(painter.theme.small);
    const float y =
        static_cast<float>(card.y + card.height) - painter.theme.small->FontSize - 9 * dp;
    const bool warns = state.notice.empty() && state.hint_is_warning;
    ImGui::GetWindowDrawList()->AddText({start.x, y}, warns ? kSuspiciousColour : kTextColour,
                                        fitted(foot, inner).c_str());
    ImGui::PopFont();
  }
  ImGui::End();
}

// What the marks on the drawing mean, at the left where the colours' legend stands otherwise.
void draw_sight_legend(const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  ImFont* font = painter.theme.small;
  const float step = font->FontSize + 12 * dp;
  const ImVec2 at(14 * dp, static_cast<float>(painter.layout.strip.height) + 14 * dp);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(at, {at.x + 150 * dp, at.y + 3 * step + 8 * dp}, kPanelColour, 8 * dp);
  const float r = 8 * dp;
  const auto row = [&](int i, const char* text) {
    const ImVec2 c(at.x + 20 * dp, at.y + 4 * dp + (static_cast<float>(i) + 0.5F) * step);
    list.AddText(font, font->FontSize, {c.x + 20 * dp, c.y - 0.5F * font->FontSize}, kTextColour,
                 text);
    return c;
  };
  list.AddCircleFilled(row(0, "known"), r, kTextColour, 24);
  list.AddCircle(row(1, "partly"), 0.8F * r, kSuspiciousColour, 24, 0.4F * r);
  draw_mark(list, StatusMark::kNotMeasured, row(2, "not seen"), r);
}

// A frame about the last good view and what to do with it; the view itself is drawn already.
void draw_still(const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const Rect& still = painter.layout.still;
  const Rect& words = painter.layout.still_words;
  const auto corner = [](double x, double y) {
    return ImVec2(static_cast<float>(x), static_cast<float>(y));
  };
  const ImVec2 low = corner(still.x, still.y);
  const ImVec2 high = corner(words.x + words.width, words.y + words.height);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(corner(words.x, words.y), high, kPanelColour);
  list.AddRect(low, high, kSuspiciousColour, 0, 0, 2 * dp);
  ImFont* font = painter.theme.body;
  ImGui::PushFont(font);
  const std::string text = fitted("Look at this again", static_cast<float>(words.width) - 16 * dp);
  ImGui::PopFont();
  const float y =
      static_cast<float>(words.y) + 0.5F * (static_cast<float>(words.height) - font->FontSize);
  list.AddText(font, font->FontSize, {low.x + 10 * dp, y}, kTextColour, text.c_str());
}

// A frame about the whole picture: nobody takes it for the live one.
void draw_frozen(const Painter& painter) {
  const auto dp = static_cast<float>(painter.theme.dp);
  const Rect& view = painter.layout.work_view;
  const float half = 2 * dp;
  ImGui::GetForegroundDrawList()->AddRect(
      {half, half}, {static_cast<float>(view.width) - half, static_cast<float>(view.height) - half},
      kGhostColour, 0, 0, 2 * half);
}

// What is asked for now and then, and what is there while it makes sense.
void draw_extras(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  if (state.detached) {
    if (big_button(painter, "Camera", layout.extras[0], "view"))
      commands.push_back({Action::kCameraView});
  } else if (state.can_replay && big_button(painter, "Replay", layout.extras[0])) {
    commands.push_back({Action::kReplay});
  }
  if (!state.menu_open) return;
  if (big_button(painter, "Save", layout.extras[1], "last 10 s"))
    commands.push_back({Action::kSaveLast});
  if (state.aligned && big_button(painter, "View", layout.extras[2], state.view_word))
    commands.push_back({Action::kView});
  if (state.has_results && !state.readout_shown &&
      big_button(painter, "Results", layout.extras[3], "of the check"))
    commands.push_back({Action::kResults});
  if (state.has_evidence && big_button(painter, "Evidence", layout.extras[4], "captures"))
    commands.push_back({Action::kEvidence});
}

}  // namespace

void draw_work(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const Layout& layout = painter.layout;
  if (state.still_shown) draw_still(painter);
  if (state.sight_shown) draw_sight_legend(painter);
  if (state.list_open && state.measured && !state.readout_shown)
    draw_list(state, painter, commands);
  draw_card(state, painter, commands);
  if (big_button(painter, "Align", layout.actions[0])) commands.push_back({Action::kAlign});
  if (state.measured) {
    if (big_button(painter, "Check", layout.actions[1], state.checking ? "working" : "",
                   ButtonLook::kPrimary)) {
      commands.push_back({Action::kCheck});
    }
  } else if (state.can_find &&
             big_button(painter, "Find", layout.actions[1], "the spool", ButtonLook::kPrimary)) {
    commands.push_back({Action::kFind});
  }
  if (state.can_capture_again) {
    if (big_button(painter, "Capture", layout.actions[2], "again", ButtonLook::kPrimary))
      commands.push_back({Action::kCaptureAgain});
  } else if (state.can_accept) {
    if (big_button(painter, "Accept", layout.actions[2], state.accept_word, ButtonLook::kPrimary))
      commands.push_back({Action::kAcceptStep});
  } else if (big_button(painter, "Shot", layout.actions[2])) {
    commands.push_back({Action::kShot});
  }
  if (state.frozen) {
    draw_frozen(painter);
    if (big_button(painter, "Live", layout.actions[3], "go on", ButtonLook::kPrimary))
      commands.push_back({Action::kFreeze});
  } else if (state.measured && big_button(painter, "Freeze", layout.actions[3])) {
    commands.push_back({Action::kFreeze});
  }
  if (big_button(painter, "More", layout.actions[4], state.menu_open ? "close" : ""))
    commands.push_back({Action::kMenu});
  draw_extras(state, painter, commands);
}

}  // namespace spool::ui
