// The NCR screen: the form of a non-conformance report, block by block, filled in by touch.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "app/ui/panels.h"

namespace spool::ui {

namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// A line of the form's own text: what is inside ends in "…" rather than on its neighbour.
void draw_text(ImFont* font, ImVec2 at, ImU32 tint, const std::string& text, double room) {
  ImGui::PushFont(font);
  ImGui::GetWindowDrawList()->AddText(at, tint, fitted(text, static_cast<float>(room)).c_str());
  ImGui::PopFont();
}

bool draw_target(const Painter& painter, const std::string& name, const Rect& rect, ImU32 fill) {
  const double dp = painter.theme.dp;
  painter.targets.targets.push_back({name, rect});
  ImGui::SetCursorScreenPos(vec(rect.x, rect.y));
  const bool is_pressed = ImGui::InvisibleButton(name.c_str(), vec(rect.width, rect.height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low = vec(rect.x, rect.y), high = vec(rect.x + rect.width, rect.y + rect.height);
  list.AddRectFilled(low, high, ImGui::IsItemActive() ? kButtonDownColour : fill,
                     static_cast<float>(8 * dp));
  list.AddRect(low, high, IM_COL32(255, 255, 255, 40), static_cast<float>(8 * dp));
  return is_pressed;
}

void draw_choices(const Painter& painter, const FormLine& line, const Rect& row,
                  std::vector<Command>& commands) {
  const double dp = painter.theme.dp, gap = 4 * dp;
  const auto count = static_cast<double>(line.choices.size());
  const double width = (row.width - (count - 1) * gap) / count;
  for (std::size_t i = 0; i < line.choices.size(); ++i) {
    const bool is_chosen = static_cast<int>(i) == line.chosen;
    const Rect rect{row.x + static_cast<double>(i) * (width + gap), row.y, width, row.height};
    if (draw_target(painter, line.label + ": " + line.choices[i], rect,
                    is_chosen ? kPrimaryColour : kButtonColour))
      commands.push_back({Action::kChooseField, static_cast<int>(i), line.field});
    // The mark says it where colours do not.
    const double middle = rect.y + 0.5 * rect.height;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 centre = vec(rect.x + 22 * dp, middle);
    list.AddCircle(centre, static_cast<float>(11 * dp), kTextColour, 24,
                   static_cast<float>(2 * dp));
    if (is_chosen) list.AddCircleFilled(centre, static_cast<float>(6 * dp), kTextColour, 24);
    draw_text(
        painter.theme.body,
        vec(rect.x + 42 * dp, middle - 0.5 * static_cast<double>(painter.theme.body->FontSize)),
        kTextColour, line.choices[i], rect.width - 48 * dp);
  }
}

void draw_form_line(const Painter& painter, const FormLine& line, const Rect& row,
                    std::vector<Command>& commands) {
  const double dp = painter.theme.dp, label = (kFormRowDp - kTargetDp - 4) * dp;
  draw_text(painter.theme.small, vec(row.x + 4 * dp, row.y), kDimTextColour, line.label,
            row.width - 8 * dp);
  const Rect box{row.x, row.y + label, row.width, kTargetDp * dp};
  if (!line.choices.empty()) {
    draw_choices(painter, line, box, commands);
    return;
  }
  if (draw_target(painter, line.label, box, kButtonColour))
    commands.push_back({Action::kTypeField, -1, line.field});
  // The first two lines of what is there.
  const std::string value = line.value.empty() ? "to be filled in" : line.value;
  const ImU32 tint = line.value.empty() ? kDimTextColour : kTextColour;
  const auto first_end = value.find('\n');
  const auto size = static_cast<double>(painter.theme.body->FontSize);
  const double room = box.width - 24 * dp;
  const bool is_one = first_end == std::string::npos;
  const double y = box.y + 0.5 * box.height - (is_one ? 0.5 : 1.1) * size;
  draw_text(painter.theme.body, vec(box.x + 12 * dp, y), tint, value.substr(0, first_end), room);
  if (is_one) return;
  std::string second = value.substr(first_end + 1);
  if (const auto more = second.find('\n'); more != std::string::npos)
    second = second.substr(0, more) + " …";
  draw_text(painter.theme.body, vec(box.x + 12 * dp, y + 1.2 * size), tint, second, room);
}

}  // namespace

void draw_ncr(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const FormState& form = state.form;
  const Layout& layout = painter.layout;
  const double dp = painter.theme.dp;
  const Rect& sheet = layout.sheet;
  begin_panel(painter, "sheet", sheet);
  const double third = sheet.width / 3;
  draw_text(painter.theme.body, vec(sheet.x + 12 * dp, sheet.y + 5 * dp), kTextColour,
            form.page.empty() ? form.title : form.title + " · " + form.page, 2 * third - 24 * dp);
  draw_text(painter.theme.small, vec(sheet.x + 2 * third - 8 * dp, sheet.y + 7 * dp),
            kDimTextColour, "Signatures: by hand", third);
  double y = sheet.y + kSheetTitleDp * dp;
  for (const FormLine& line : form.lines) {
    draw_form_line(painter, line, {sheet.x + 8 * dp, y, sheet.width - 16 * dp, kFormRowDp * dp},
                   commands);
    y += kFormRowDp * dp;
  }
  ImGui::PushFont(painter.theme.small);
  ImGui::SetCursorScreenPos(vec(sheet.x + 12 * dp, y + 4 * dp));
  ImGui::PushTextWrapPos(static_cast<float>(sheet.width - 12 * dp));
  ImGui::PushStyleColor(ImGuiCol_Text, form.foot_warns ? kSuspiciousColour : kTextColour);
  ImGui::TextWrapped("%s", form.foot.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::End();
  if (form.can_write &&
      big_button(painter, "Write", layout.actions[0], form.is_writing ? "working" : "the report",
                 ButtonLook::kPrimary))
    commands.push_back({Action::kWriteNcr});
  if (form.can_go_on && big_button(painter, "Next", layout.actions[1], "page"))
    commands.push_back({Action::kTurnPage, -1, 1});
  if (form.can_go_back && big_button(painter, "Previous", layout.actions[2], "page"))
    commands.push_back({Action::kTurnPage, -1, -1});
  if (big_button(painter, "Back", layout.actions[4], form.can_write ? "keeps it" : ""))
    commands.push_back({Action::kLeave});
}

}  // namespace spool::ui
