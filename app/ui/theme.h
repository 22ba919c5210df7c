// Colours, type and spacing of the screen: dark, large, in density-independent units.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <imgui.h>

#include "app/ui/screen_state.h"
#include "vision/core/result.h"

namespace spool::ui {

// The colours on dark.
inline constexpr ImU32 kOkColour = IM_COL32(0x2B, 0xB9, 0x8A, 255);
inline constexpr ImU32 kSuspiciousColour = IM_COL32(0xF0, 0xB4, 0x29, 255);
inline constexpr ImU32 kNotOkColour = IM_COL32(0xFF, 0x6B, 0x4A, 255);
inline constexpr ImU32 kNotMeasuredColour = IM_COL32(0xA7, 0xAD, 0xB5, 255);
inline constexpr ImU32 kGhostColour = IM_COL32(0x56, 0xB4, 0xE9, 255);
inline constexpr ImU32 kTextColour = IM_COL32(0xF2, 0xF4, 0xF6, 255);
inline constexpr ImU32 kDimTextColour = IM_COL32(0xB8, 0xC0, 0xC8, 255);
inline constexpr ImU32 kPanelColour = IM_COL32(0x12, 0x16, 0x1B, 224);  // over the steel
inline constexpr ImU32 kButtonColour = IM_COL32(0x26, 0x2E, 0x37, 240);
inline constexpr ImU32 kButtonDownColour = IM_COL32(0x3C, 0x4A, 0x58, 255);
inline constexpr ImU32 kPrimaryColour = IM_COL32(0x0E, 0x63, 0x9C, 255);

struct Theme {
  double dp = 1;  // px
  ImFont* body = nullptr;
  ImFont* small = nullptr;
  ImFont* number = nullptr;
};

// Sets the current ImGui context's style and loads the three sizes of type from a TrueType or
// OpenType file's bytes. kInternal where they are not a font.
[[nodiscard]] Result<Theme> load_theme(std::string_view font_file, double dp);

[[nodiscard]] ImU32 colour(StatusMark mark);
[[nodiscard]] const char* word(StatusMark mark);  // "OK", "Can't tell", "Out", "Not seen"

}  // namespace spool::ui
