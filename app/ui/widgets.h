// The few widgets of the screen: a large button, a status mark, a floating panel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <imgui.h>

#include "app/ui/targets.h"
#include "app/ui/theme.h"

namespace spool::ui {

// What every panel draws with.
struct Painter {
  const Theme& theme;
  const Layout& layout;
  TargetList& targets;
};

enum class ButtonLook { kPlain, kPrimary };

// A button that fills `rect`, in a window of its own; `detail` is a smaller second line or empty.
// True in the frame of its release.
[[nodiscard]] bool big_button(const Painter& painter, const char* label, const Rect& rect,
                              const std::string& detail = {}, ButtonLook look = ButtonLook::kPlain);

// Opens an undecorated window at `rect`; close with ImGui::End(). `background` false: draw your
// own.
void begin_panel(const Painter& painter, const char* name, const Rect& rect,
                 bool background = true);

// The outline of a status about `centre`, radius in px: circle with tick, triangle with question
// mark, octagon with bar, dashed ring.
void draw_mark(ImDrawList& list, StatusMark mark, ImVec2 centre, float radius);
// A dot for tracking: filled, half, hollow with a bar; two bars where it stands still.
void draw_tracking(ImDrawList& list, TrackingMark mark, ImVec2 centre, float radius);

// A panel that a finger drags up and down, to be closed with end_drag_panel(). True while a finger
// drags it and in the frame of its release: that is no tap on what lies in it.
[[nodiscard]] bool begin_drag_panel(const Painter& painter, const char* name, const Rect& rect);
// Closes it, with a mark of where one is where it holds more than it shows. The mark is no target.
void end_drag_panel(const Painter& painter, const Rect& rect);

// Text in lines of up to `width` px from `at` down, the last of `most_lines` ending in "…" where
// there is more. Returns the y (px) under it.
float draw_lines(ImDrawList& list, ImFont* font, ImVec2 at, ImU32 tint, const std::string& text,
                 float width, int most_lines);

// Text that ends in "…" where it would pass `width` px.
[[nodiscard]] std::string fitted(const std::string& text, float width);

}  // namespace spool::ui
