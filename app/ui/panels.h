// The screens as Dear ImGui panels: read a ScreenState, return what was asked for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/ui/screen_state.h"
#include "app/ui/widgets.h"

namespace spool::ui {

// Between ImGui::NewFrame() and ImGui::Render(). Everything that can be tapped is in `targets`
// afterwards.
[[nodiscard]] std::vector<Command> draw_screen(const ScreenState& state, const Theme& theme,
                                               const Layout& layout, TargetList& targets);

// The pieces that the screens share or that have files of their own.
void draw_strip(const ScreenState& state, const Painter& painter);
void draw_find_bar(const Painter& painter, double share);  // within the open panel
void draw_align(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);
void draw_choose(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);
void draw_results(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);
void draw_readout(const ScreenState& state, const Painter& painter);  // within the open panel
void draw_work(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);
void draw_evidence(const ScreenState& state, const Painter& painter,
                   std::vector<Command>& commands);
void draw_ncr(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);
void draw_typing(const ScreenState& state, const Painter& painter, std::vector<Command>& commands);

}  // namespace spool::ui
