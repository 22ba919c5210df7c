// The few widgets of the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spool::ui {

namespace {

constexpr double kDragSlopDp = 19;  // 3 mm: a glove rolls so far in a tap

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

void centred_text(ImDrawList& list, ImFont* font, ImVec2 centre, ImU32 tint,
                  const std::string& text) {
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, text.c_str());
  list.AddText(font, font->FontSize,
               {std::floor(centre.x - 0.5F * size.x), std::floor(centre.y - 0.5F * size.y)}, tint,
               text.c_str());
}

constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

// Two upright bars: it stands still.
void draw_bars(ImDrawList& list, ImVec2 c, float r, ImU32 tint) {
  for (const float side : {-0.45F, 0.45F})
    list.AddRectFilled({c.x + (side - 0.22F) * r, c.y - r}, {c.x + (side + 0.22F) * r, c.y + r},
                       tint);
}
}  // namespace

void begin_panel(const Painter& painter, const char* name, const Rect& rect, bool background) {
  painter.targets.panels.push_back(rect);
  ImGui::SetNextWindowPos(vec(rect.x, rect.y));
  ImGui::SetNextWindowSize(vec(rect.width, rect.height));
  ImGui::Begin(name, nullptr, background ? kBare : kBare | ImGuiWindowFlags_NoBackground);
}

bool big_button(const Painter& painter, const char* label, const Rect& rect,
                const std::string& detail, ButtonLook look) {
  painter.targets.targets.push_back({label, rect});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  begin_panel(painter, label, rect, false);
  const bool pressed = ImGui::InvisibleButton(label, vec(rect.width, rect.height));
  const bool down = ImGui::IsItemActive() && ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto dp = static_cast<float>(painter.theme.dp);
  const ImU32 fill =
      down ? kButtonDownColour : (look == ButtonLook::kPrimary ? kPrimaryColour : kButtonColour);
  const ImVec2 low = vec(rect.x, rect.y);
  const ImVec2 high = vec(rect.x + rect.width, rect.y + rect.height);
  list.AddRectFilled(low, high, fill, 10 * dp);
  list.AddRect(low, high, IM_COL32(255, 255, 255, 40), 10 * dp);
  const ImVec2 centre = vec(rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height);
  if (detail.empty()) {
    centred_text(list, painter.theme.body, centre, kTextColour, label);
  } else {
    centred_text(list, painter.theme.body, {centre.x, centre.y - 10 * dp}, kTextColour, label);
    centred_text(list, painter.theme.small, {centre.x, centre.y + 12 * dp}, kDimTextColour, detail);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return pressed;
}

void draw_mark(ImDrawList& list, StatusMark mark, ImVec2 c, float r) {
  const ImU32 tint = colour(mark);
  const ImU32 dark = IM_COL32(0x10, 0x14, 0x18, 255);
  const float thick = std::max(1.5F, 0.2F * r);
  switch (mark) {
    case StatusMark::kOk:
      list.AddCircleFilled(c, r, tint, 24);
      list.AddLine({c.x - 0.45F * r, c.y}, {c.x - 0.1F * r, c.y + 0.4F * r}, dark, thick);
      list.AddLine({c.x - 0.1F * r, c.y + 0.4F * r}, {c.x + 0.5F * r, c.y - 0.4F * r}, dark, thick);
      break;
    case StatusMark::kSuspicious: {
      list.AddTriangleFilled({c.x, c.y - r}, {c.x + r, c.y + 0.8F * r}, {c.x - r, c.y + 0.8F * r},
                             tint);
      const ImVec2 top(c.x, c.y - 0.02F * r);
      list.PathArcTo(top, 0.27F * r, -static_cast<float>(std::numbers::pi), 0.6F, 8);
      list.PathLineTo({c.x, c.y + 0.38F * r});
      list.PathStroke(dark, 0, 0.75F * thick);
      list.AddCircleFilled({c.x, c.y + 0.6F * r}, 0.6F * thick, dark, 8);
      break;
    }
    case StatusMark::kNotOk:
      for (int i = 0; i < 8; ++i) {
        const float angle =
            (static_cast<float>(i) + 0.5F) * static_cast<float>(std::numbers::pi) / 4;
        list.PathLineTo({c.x + r * std::cos(angle), c.y + r * std::sin(angle)});
      }
      list.PathFillConvex(tint);
      list.AddLine({c.x - 0.5F * r, c.y}, {c.x + 0.5F * r, c.y}, dark, 1.4F * thick);
      break;
    case StatusMark::kNotMeasured:
      for (int i = 0; i < 6; ++i) {
        const float from = static_cast<float>(i) * static_cast<float>(std::numbers::pi) / 3;
        list.PathArcTo(c, 0.9F * r, from, from + 0.65F, 6);
        list.PathStroke(tint, 0, thick);
      }
      break;
  }
}

void draw_tracking(ImDrawList& list, TrackingMark mark, ImVec2 c, float r) {
  const auto pi = static_cast<float>(std::numbers::pi);
  switch (mark) {
    case TrackingMark::kGood:
      list.AddCircleFilled(c, r, kOkColour, 20);
      break;
    case TrackingMark::kPoor:
      list.AddCircle(c, r, kSuspiciousColour, 20, 0.25F * r);
      list.PathArcTo(c, r, 0.5F * pi, 1.5F * pi, 12);
      list.PathFillConvex(kSuspiciousColour);
      break;
    case TrackingMark::kPaused:
      draw_bars(list, c, r, kSuspiciousColour);
      break;
    case TrackingMark::kFrozen:
      draw_bars(list, c, r, kGhostColour);
      break;
    case TrackingMark::kLost:
      list.AddCircle(c, r, kNotOkColour, 20, 0.3F * r);
      list.AddLine({c.x - 0.6F * r, c.y + 0.6F * r}, {c.x + 0.6F * r, c.y - 0.6F * r}, kNotOkColour,
                   0.3F * r);
      break;
    case TrackingMark::kNone:
      list.AddCircle(c, r, kNotMeasuredColour, 20, 0.25F * r);
      break;
  }
}

bool begin_drag_panel(const Painter& painter, const char* name, const Rect& rect) {
  begin_panel(painter, name, rect);
  const ImGuiIO& io = ImGui::GetIO();
  const double slop = kDragSlopDp * painter.theme.dp;
  const bool is_dragged =
      (io.MouseDown[0] || io.MouseReleased[0]) &&
      rect.contains(double{io.MouseClickedPos[0].x}, double{io.MouseClickedPos[0].y}) &&
      double{io.MouseDragMaxDistanceSqr[0]} > slop * slop;
  if (is_dragged && io.MouseDown[0]) ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
  const ImVec2 at = ImGui::GetCursorScreenPos();  // what lies in it stands on whole pixels
  ImGui::SetCursorScreenPos({std::ceil(at.x), std::ceil(at.y)});
  return is_dragged;
}

void end_drag_panel(const Painter& painter, const Rect& rect) {
  const float most = ImGui::GetScrollMaxY(), at = ImGui::GetScrollY();
  if (most > 0) {
    const auto dp = static_cast<float>(painter.theme.dp);
    const auto height = static_cast<float>(rect.height);
    const float shown = height * height / (height + most);
    const float top =
        static_cast<float>(rect.y) + (height - shown) * std::clamp(at / most, 0.0F, 1.0F);
    const float right = static_cast<float>(rect.x + rect.width) - 3 * dp;
    ImGui::GetWindowDrawList()->AddRectFilled({right - 5 * dp, top}, {right, top + shown},
                                              kNotMeasuredColour, 2.5F * dp);
  }
  ImGui::End();
}

float draw_lines(ImDrawList& list, ImFont* font, ImVec2 at, ImU32 tint, const std::string& text,
                 float width, int most_lines) {
  ImGui::PushFont(font);
  const char* from = text.c_str();
  const char* end = from + text.size();
  for (int line = 0; from < end && line < most_lines; ++line) {
    const bool is_last = line + 1 == most_lines;
    const char* to = is_last ? end : font->CalcWordWrapPositionA(1.0F, from, end, width);
    if (to <= from) to = end;  // not one word has room
    const std::string words = fitted(std::string(from, to), width);
    list.AddText(font, font->FontSize, at, tint, words.c_str());
    at.y += font->FontSize;
    from = to;
    while (from < end && *from == ' ') ++from;
  }
  ImGui::PopFont();
  return at.y;
}

std::string fitted(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string cut = text;
  while (!cut.empty()) {
    // Whole UTF-8 characters go.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U)
      cut.pop_back();
    if (!cut.empty()) cut.pop_back();
    if (ImGui::CalcTextSize((cut + "…").c_str()).x <= width) return cut + "…";
  }
  return "…";
}

}  // namespace spool::ui
