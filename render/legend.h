// What the colours mean: a bar with numbers and unit, the tolerance marked, other points named.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/canvas.h"
#include "render/font_atlas.h"
#include "render/overlay.h"

namespace spool::render {

struct LegendContent {
  double range_m = 0.010;      // m; the ends of the bar
  double neutral_m = 0.001;    // m; half width of the grey band
  double tolerance_m = 0.003;  // m
  LengthDisplay units = LengthDisplay::kMillimetre;
  bool has_clutter = false;        // points that are not the object are shown
  bool has_contradicting = false;  // points that contradict the design are shown
};

// The legend at the left edge of a picture, half way down the `height` px that begin at `top_px`.
// `scale` as in OverlayStyle; `font` is of the size that legend_text_px() says. Knows no GL.
[[nodiscard]] Canvas draw_legend(const LegendContent& content, int width, int height, double scale,
                                 const FontAtlas& font, double top_px = 0);

// The size (px) of the legend's text; `font`.
[[nodiscard]] float legend_text_px(double scale);

// A signed length as the legend writes it: "+3", "0", "\u22120.5" (mm); "+1/8", "\u22123/16" as set
// fractions, or a decimal where no 32nd of an inch is within 0.05 mm (inch).
[[nodiscard]] std::string legend_number(double length_m, LengthDisplay units);

// The spacing (m) of the bar's numbers: the least round one that leaves at most four a side.
[[nodiscard]] double legend_step(double range_m, LengthDisplay units);

}  // namespace spool::render
