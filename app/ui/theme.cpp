// Colours, type and spacing of the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/theme.h"

#include <cmath>

#include "app/ui/layout.h"

namespace spool::ui {

Result<Theme> load_theme(std::string_view font_file, double dp) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // where windows stand is ours
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_IsTouchScreen;
  ImGuiStyle& style = ImGui::GetStyle();
  ImGui::StyleColorsDark(&style);
  const auto d = static_cast<float>(dp);
  style.WindowPadding = {12 * d, 8 * d};
  style.FramePadding = {10 * d, 8 * d};
  style.ItemSpacing = {8 * d, 4 * d};
  style.WindowRounding = style.FrameRounding = 8 * d;
  style.WindowBorderSize = 0;
  style.ScrollbarSize = 28 * d;
  style.WindowMinSize = {1, 1};
  style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(kPanelColour);
  style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(kTextColour);

  // Latin with the letters of names in all of Europe, and the marks that numbers and directions
  // need.
  static const ImWchar ranges[] = {0x0020, 0x017F, 0x2010, 0x2026, 0x2044, 0x2044,
                                   0x2190, 0x2193, 0x2212, 0x2212, 0};
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  const auto load = [&](double size_sp) {
    // ImGui copies nothing and writes nothing; its interface is only not const.
    return io.Fonts->AddFontFromMemoryTTF(
        const_cast<char*>(font_file.data()), static_cast<int>(font_file.size()),
        std::round(static_cast<float>(size_sp * dp)), &config, ranges);
  };
  Theme theme;
  theme.dp = dp;
  if (!font_file.empty()) {
    theme.body = load(kBodySp);
    theme.small = load(kSmallSp);
    theme.number = load(kNumberSp);
  }
  if (theme.body == nullptr || theme.small == nullptr || theme.number == nullptr ||
      !io.Fonts->Build()) {
    return Error{ErrorCode::kInternal,
                 "the font built into the program cannot be read; build it anew"};
  }
  return theme;
}

ImU32 colour(StatusMark mark) {
  switch (mark) {
    case StatusMark::kOk:
      return kOkColour;
    case StatusMark::kSuspicious:
      return kSuspiciousColour;
    case StatusMark::kNotOk:
      return kNotOkColour;
    case StatusMark::kNotMeasured:
      break;
  }
  return kNotMeasuredColour;
}

const char* word(StatusMark mark) {
  switch (mark) {
    case StatusMark::kOk:
      return "OK";
    case StatusMark::kSuspicious:
      return "Can't tell";
    case StatusMark::kNotOk:
      return "Out";
    case StatusMark::kNotMeasured:
      break;
  }
  return "Not seen";
}

}  // namespace spool::ui
