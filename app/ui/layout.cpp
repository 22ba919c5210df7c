// Where things stand on a screen of any size.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/layout.h"

#include <algorithm>
#include <cmath>

namespace spool::ui {

namespace {
constexpr double kLeastDotsPerInch = 160;
constexpr double kMarginDp = 8;
constexpr double kStripDp = 52;
constexpr double kCardDp = 132;
constexpr double kCardWidthDp = 640;
constexpr double kActionWidthDp = 96;
constexpr double kLegendDp = 160;        // width of the deviation colours at the left edge
constexpr double kLegendHeightDp = 330;  // it can be drawn lower but not read well
constexpr double kStillDp = 180;         // height of the last good view
constexpr double kStillShare = 0.3;      // or of the screen's, where that is less
constexpr double kStillWordsDp = 32;
constexpr double kSheetFootDp = 28;  // what is said under the rows

// Beside the last actions in landscape, above them in portrait; over the card, which stays free.
// The list of parts has what is left.
void place_extras(Layout& out, double dp) {
  const double margin = kMarginDp * dp, height = kTargetDp * dp, least = 2.0 * dp;
  const Rect& action = out.actions[kActions - 1];
  const double x = out.portrait ? action.x : action.x - margin - action.width;
  const double room = out.card.y - out.strip.height;  // gaps close up before targets shrink
  const int rows = std::clamp(static_cast<int>(room / (height + least)), 1, kExtras);
  const double gap = std::clamp((room - rows * height) / rows, least, margin);
  for (int i = 0; i < kExtras; ++i)
    out.extras[i] = {x - (i / rows) * (margin + action.width),
                     out.card.y - (i % rows + 1) * (height + gap), action.width, height};
  const double top = out.strip.height + margin;
  out.list = {out.card.x, top,
              std::min(out.card.width, out.extras[kExtras - 1].x - margin - out.card.x),
              out.card.y - margin - top};
}

// Half of what is beside the actions, in whole pixels, as one picture is drawn beside it.
void place_results(Layout& out, double width_px, double dp) {
  const double margin = kMarginDp * dp, top = std::floor(out.strip.height);
  if (out.portrait) {
    const double end = out.actions[0].y - margin, half = std::floor(0.5 * (end - top));
    out.results_view = {0, top, width_px, half};
    out.results = {margin, top + half + margin, width_px - 2 * margin, end - top - half - margin};
    return;
  }
  const double end = out.actions[0].x - margin;
  const double width = std::floor(std::min(kCardWidthDp * dp, 0.5 * end));
  const double bottom = out.card.y + out.card.height;
  out.results = {end - width, top + margin, width, bottom - top - margin};
  out.results_view = {0, top, std::floor(end - width - margin), std::floor(bottom + margin - top)};
}

// Above the card, where nothing else is while the spool is lost; in whole pixels.
void place_still(Layout& out, double height_px, double dp) {
  const double margin = kMarginDp * dp, words = std::floor(kStillWordsDp * dp);
  const double top = out.strip.height + margin, bottom = std::floor(out.card.y - margin);
  const double most = std::min(kStillDp * dp, kStillShare * height_px);
  const double height = std::floor(std::clamp(bottom - top - words, 0.0, most));
  const double width = std::floor(height * 4 / 3), x = std::floor(margin);
  out.still = {x, bottom - words - height, width, height};
  out.still_words = {x, bottom - words, width, words};
}
}  // namespace

double pixels_per_dp(double dots_per_inch) {
  return std::max(dots_per_inch, kLeastDotsPerInch) / kLeastDotsPerInch;
}

Layout lay_out(double width_px, double height_px, double dp) {
  Layout out;
  const double margin = kMarginDp * dp;
  const double target = kTargetDp * dp;
  out.portrait = height_px > width_px;
  out.strip = {0, 0, width_px, kStripDp * dp};
  out.work_view = {0, 0, width_px, height_px};
  const double top = out.strip.height;
  if (out.portrait) {
    const double step = (width_px - margin) / kActions;
    const double y = height_px - target - margin;
    for (int i = 0; i < kActions; ++i) {
      out.actions[i] = {margin + i * step, y, step - margin, target};
    }
    out.card = {margin, y - margin - kCardDp * dp, width_px - 2 * margin, kCardDp * dp};
    out.align_card = out.card;
    out.sheet = {margin, top + margin, width_px - 2 * margin, y - top - 2 * margin};
    place_extras(out, dp);
    place_still(out, height_px, dp);
    place_results(out, width_px, dp);
    out.legend_bottom = out.card.y;
    const double half = std::floor(0.5 * (out.card.y - margin - top));
    out.design_view = {0, top, width_px, half};
    out.scan_view = {0, top + half, width_px, half};
    return out;
  }
  const double width = std::max(kActionWidthDp * dp, target);
  const double x = width_px - width - margin;
  out.strip.width = x - margin;
  // The column has the whole height of the edge where the thumb is; it closes up before targets
  // shrink.
  const double room = height_px - 2 * margin;
  const double gap = std::clamp((room - kActions * target) / kActions, 2.0 * dp, margin);
  const double height = std::min(96 * dp, std::max(target, room / kActions - gap));
  const double column = kActions * (height + gap) - gap;
  const double first = margin + std::max(0.0, 0.5 * (room - column));
  for (int i = 0; i < kActions; ++i) {
    out.actions[i] = {x, first + i * (height + gap), width, height};
  }
  // On a low screen the card stands beside the legend, else under it.
  const double card_y = height_px - margin - kCardDp * dp;
  const bool beside = card_y - top < kLegendHeightDp * dp;
  const double card_x = beside ? kLegendDp * dp : margin;
  out.card = {card_x, card_y, std::min(kCardWidthDp * dp, x - card_x - margin), kCardDp * dp};
  place_extras(out, dp);
  place_still(out, height_px, dp);
  place_results(out, width_px, dp);
  out.legend_bottom = beside ? height_px : card_y;
  out.sheet = {margin, top + margin, x - 2 * margin, height_px - top - 2 * margin};
  out.align_card = {margin, out.card.y, x - 2 * margin, out.card.height};
  const double half = std::floor(0.5 * (x - margin));
  const double view_height = std::floor(out.card.y - margin - top);
  out.design_view = {0, top, half, view_height};
  out.scan_view = {half, top, half, view_height};
  return out;
}

int sheet_rows(const Layout& layout, double dp, double row_dp) {
  const double room = layout.sheet.height - (kSheetTitleDp + kSheetFootDp) * dp;
  return std::max(1, static_cast<int>(room / (row_dp * dp)));
}

}  // namespace spool::ui
