// Claims about where things stand, on every size of screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/layout.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace spool::ui {
namespace {

struct ScreenSize {
  std::string name;
  double width, height, dots_per_inch;
};

const std::vector<ScreenSize>& sizes() {
  static const std::vector<ScreenSize> table{
      {"tablet", 1280, 800, 150},        {"panel", 800, 480, 133},    {"portrait", 1080, 1920, 220},
      {"large tablet", 2560, 1600, 280}, {"desktop", 1920, 1080, 96}, {"phone", 2340, 1080, 400},
  };
  return table;
}

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(Layout, EveryTargetIsAThumbWideOnEveryScreen) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const double dp = pixels_per_dp(size.dots_per_inch);
    const Layout layout = lay_out(size.width, size.height, dp);
    std::vector<Rect> all(std::begin(layout.actions), std::end(layout.actions));
    all.insert(all.end(), std::begin(layout.extras), std::end(layout.extras));
    for (const Rect& action : all) {
      EXPECT_GE(action.width, kTargetDp * dp - 0.5);
      EXPECT_GE(action.height, kTargetDp * dp - 0.5);
    }
    // 12 mm of glass.
    EXPECT_GE(layout.actions[0].height / size.dots_per_inch * 25.4, 11.9);
  }
}

TEST(Layout, ExtrasStandBesideTheActionsOverTheSteel) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const Layout layout = lay_out(size.width, size.height, pixels_per_dp(size.dots_per_inch));
    std::vector<Rect> all(std::begin(layout.actions), std::end(layout.actions));
    all.insert(all.end(), std::begin(layout.extras), std::end(layout.extras));
    all.insert(all.end(), {layout.strip, layout.card});
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j)
        EXPECT_FALSE(overlap(all[i], all[j])) << i << " and " << j;
    for (const Rect& extra : layout.extras) {
      EXPECT_GE(extra.x, 0);
      EXPECT_FALSE(overlap(extra, layout.still));
    }
  }
}

TEST(Layout, NothingOverlapsAndNothingLeavesTheScreen) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const Layout layout = lay_out(size.width, size.height, pixels_per_dp(size.dots_per_inch));
    std::vector<Rect> all(std::begin(layout.actions), std::end(layout.actions));
    all.insert(all.end(), {layout.strip, layout.align_card, layout.design_view, layout.scan_view});
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_GE(all[i].x, 0);
      EXPECT_GE(all[i].y, 0);
      EXPECT_LE(all[i].x + all[i].width, size.width + 0.01);
      EXPECT_LE(all[i].y + all[i].height, size.height + 0.01);
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        EXPECT_FALSE(overlap(all[i], all[j])) << i << " and " << j;
      }
    }
  }
}

TEST(Layout, TheSheetFillsWhatStripAndActionsLeave) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const double dp = pixels_per_dp(size.dots_per_inch);
    const Layout layout = lay_out(size.width, size.height, dp);
    EXPECT_FALSE(overlap(layout.sheet, layout.strip));
    for (const Rect& action : layout.actions) EXPECT_FALSE(overlap(layout.sheet, action));
    EXPECT_LE(layout.sheet.x + layout.sheet.width, size.width);
    EXPECT_LE(layout.sheet.y + layout.sheet.height, size.height);
    for (const double row : {kRowDp, kFormRowDp}) {
      const int rows = sheet_rows(layout, dp, row);
      EXPECT_GE(rows, 3);
      EXPECT_LE(kSheetTitleDp * dp + rows * row * dp, layout.sheet.height);
    }
  }
}

TEST(Layout, TheLastGoodViewCoversNothingAndIsLargeEnoughToBeKnown) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const double dp = pixels_per_dp(size.dots_per_inch);
    const Layout layout = lay_out(size.width, size.height, dp);
    for (const Rect& rect : {layout.still, layout.still_words}) {
      EXPECT_GE(rect.x, 0);
      EXPECT_FALSE(overlap(rect, layout.strip) || overlap(rect, layout.card));
      for (const Rect& action : layout.actions) EXPECT_FALSE(overlap(rect, action));
    }
    EXPECT_FALSE(overlap(layout.still, layout.still_words));
    EXPECT_NEAR(layout.still.width, layout.still.height * 4 / 3, 1) << "as depth cameras see";
    EXPECT_GT(layout.still.height, 120 * dp);
    EXPECT_LT(layout.still.width * layout.still.height, 0.2 * size.width * size.height) << "small";
  }
}

TEST(Layout, PutsTheTwoPicturesBesideEachOtherOrAboveByTheScreensShape) {
  const Layout wide = lay_out(1280, 800, 1);
  EXPECT_EQ(wide.design_view.y, wide.scan_view.y);
  const Layout tall = lay_out(800, 1280, 1);
  EXPECT_EQ(tall.design_view.x, tall.scan_view.x);
  EXPECT_LT(tall.design_view.y, tall.scan_view.y);
}

TEST(Layout, GivesTheSteelMostOfTheScreen) {
  for (const ScreenSize& size : sizes()) {
    SCOPED_TRACE(size.name);
    const Layout layout = lay_out(size.width, size.height, pixels_per_dp(size.dots_per_inch));
    double covered =
        layout.strip.width * layout.strip.height + layout.card.width * layout.card.height;
    for (const Rect& action : layout.actions) covered += action.width * action.height;
    EXPECT_LT(covered, 0.45 * size.width * size.height);
  }
}

}  // namespace
}  // namespace spool::ui
