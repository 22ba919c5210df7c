// Text entry: what is typed so far above the keyboard on the glass.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "app/ui/keyboard.h"
#include "app/ui/panels.h"

namespace spool::ui {

namespace {

constexpr double kTypedDp = 220;  // height of the text at most

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// The end of the text is in sight, where the next letter goes.
void draw_typed(const Painter& painter, const TypingState& typing, const Rect& box) {
  const double dp = painter.theme.dp;
  begin_panel(painter, "typed", box);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* small = painter.theme.small;
  ImFont* body = painter.theme.body;
  const double margin = 12 * dp, room = box.width - 2 * margin;
  ImGui::PushFont(small);
  list.AddText(vec(box.x + margin, box.y + 4 * dp), kDimTextColour,
               fitted(typing.help.empty() ? typing.label : typing.label + " · " + typing.help,
                      static_cast<float>(room))
                   .c_str());
  ImGui::PopFont();
  const double top = box.y + 24 * dp, bottom = box.y + box.height - 4 * dp;
  const std::string text = typing.text + "_";
  const ImVec2 size =
      body->CalcTextSizeA(body->FontSize, 1e6F, static_cast<float>(room), text.c_str());
  const double y =
      static_cast<double>(size.y) > bottom - top ? bottom - static_cast<double>(size.y) : top;
  ImGui::PushClipRect(vec(box.x, top), vec(box.x + box.width, bottom), true);
  list.AddText(body, body->FontSize, vec(box.x + margin, y), kTextColour, text.c_str(), nullptr,
               static_cast<float>(room));
  ImGui::PopClipRect();
  ImGui::End();
}

void draw_key(const Painter& painter, const Key& key, bool is_lit, std::vector<Command>& commands) {
  const double dp = painter.theme.dp;
  const Rect& rect = key.rect;
  painter.targets.targets.push_back({key.name, rect});
  ImGui::SetCursorScreenPos(vec(rect.x, rect.y));
  // A backspace that is held goes on.
  ImGui::PushButtonRepeat(key.role == KeyRole::kBackspace);
  if (ImGui::InvisibleButton(key.name.c_str(), vec(rect.width, rect.height)))
    commands.push_back(key.role == KeyRole::kLetter
                           ? Command{Action::kKey, -1, static_cast<int>(key.letter)}
                           : Command{Action::kKeyRole, -1, static_cast<int>(key.role)});
  ImGui::PopButtonRepeat();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 fill = ImGui::IsItemActive()                  ? kButtonDownColour
                     : key.role == KeyRole::kDone || is_lit ? kPrimaryColour
                                                            : kButtonColour;
  list.AddRectFilled(vec(rect.x, rect.y), vec(rect.x + rect.width, rect.y + rect.height), fill,
                     static_cast<float>(8 * dp));
  ImFont* font = painter.theme.body;
  const double size = key.label.size() <= 2 ? 1.4 * static_cast<double>(font->FontSize)
                                            : static_cast<double>(font->FontSize);
  const ImVec2 wide = font->CalcTextSizeA(static_cast<float>(size), 1e6F, 0, key.label.c_str());
  list.AddText(font, static_cast<float>(size),
               vec(rect.x + 0.5 * (rect.width - static_cast<double>(wide.x)),
                   rect.y + 0.5 * (rect.height - static_cast<double>(wide.y))),
               kTextColour, key.label.c_str());
}

}  // namespace

void draw_typing(const ScreenState& state, const Painter& painter, std::vector<Command>& commands) {
  const TypingState& typing = state.typing;
  const Rect& window = painter.layout.work_view;
  const std::vector<Key> keys =
      lay_out_keys(window, painter.theme.dp, typing.page, typing.is_shifted);
  const double top = keys.front().rect.y - 2 * painter.theme.dp;
  // Beside the keys, where the eyes are, also on a tall screen.
  const double height = std::min(top - window.y, kTypedDp * painter.theme.dp);
  draw_typed(painter, typing, {window.x, top - height, window.width, height});
  begin_panel(painter, "keys", {window.x, top, window.width, window.y + window.height - top});
  for (const Key& key : keys)
    draw_key(painter, key, key.role == KeyRole::kShift && typing.is_shifted, commands);
  ImGui::End();
}

}  // namespace spool::ui
