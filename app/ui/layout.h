// Where things stand on a screen of any size: the steel, the actions, the strip, the card.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/ui/screen_state.h"

namespace spool::ui {

// Pixels from the window's top left corner.
struct Rect {
  double x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool contains(double px, double py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
};

inline constexpr double kTargetDp = 76;  // the least side of a thing to tap: 12 mm
inline constexpr double kBodySp = 16;
inline constexpr double kSmallSp = 14;
inline constexpr double kNumberSp = 30;
inline constexpr int kActions = 5;
inline constexpr int kExtras = 5;
inline constexpr double kSheetTitleDp = 30;
inline constexpr double kRowDp = 80;       // of a list of things to tap, with the gap after it
inline constexpr double kFormRowDp = 100;  // of a form: with its label above

// Pixels of one density-independent unit (1/160 inch). Under 160 dots an inch text would get too
// few pixels to be read, so a unit is never less than one pixel.
[[nodiscard]] double pixels_per_dp(double dots_per_inch);

struct Layout {
  bool portrait = false;
  Rect strip;                // words along the top
  Rect actions[kActions];    // where the thumb is: right edge, or the bottom in portrait
  Rect extras[kExtras];      // beside the actions, from the thumb away: what is not always there;
                             // in as many columns as they need
  Rect list;                 // Work: the parts, above the card and clear of the extras
  Rect card;                 // Work: the readout, bottom left
  Rect still;                // Work, while the spool is lost: its last good view, 4:3
  Rect still_words;          // under it
  double legend_bottom = 0;  // the legend at the left edge ends above this
  Rect align_card;           // Align: the chips and the hint, under the two pictures
  Rect sheet;                // Evidence and its form: all between strip and actions
  Rect work_view;            // the steel: everything
  Rect design_view;          // Align: side by side, above each other in portrait
  Rect scan_view;
  Rect results;       // Results: the rows or numbers, where the thumb is
  Rect results_view;  // beside or above them: the steel
};

[[nodiscard]] Layout lay_out(double width_px, double height_px, double dp);

// Whole rows of `row_dp` that the sheet has under a title line; 1 at least.
[[nodiscard]] int sheet_rows(const Layout& layout, double dp, double row_dp);

}  // namespace spool::ui
