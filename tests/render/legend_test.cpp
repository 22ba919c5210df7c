// The legend as data: numbers, units and what it says of which points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/legend.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "render/deviation_colour.h"

namespace spool::render {
namespace {

TEST(LegendNumber, WritesMillimetresWithASignAndNoIdleZeros) {
  EXPECT_EQ(legend_number(0.003, LengthDisplay::kMillimetre), "+3");
  EXPECT_EQ(legend_number(-0.0025, LengthDisplay::kMillimetre),
            "\xE2\x88\x92"
            "2.5");
  EXPECT_EQ(legend_number(0.010, LengthDisplay::kMillimetre), "+10");
  EXPECT_EQ(legend_number(0, LengthDisplay::kMillimetre), "0");
  EXPECT_EQ(legend_number(-0.000001, LengthDisplay::kMillimetre), "0");
}

TEST(LegendNumber, SetsFractionsOfAnInch) {
  EXPECT_EQ(legend_number(0.0254 * 3 / 16, LengthDisplay::kFeetInch),
            "+\xC2\xB3\xE2\x81\x84\xE2\x82\x81\xE2\x82\x86");
  EXPECT_EQ(legend_number(-0.0254 * 1.5, LengthDisplay::kFeetInch),
            "\xE2\x88\x92"
            "1\xC2\xB9\xE2\x81\x84\xE2\x82\x82");
  EXPECT_EQ(legend_number(0.0254 * 2, LengthDisplay::kFeetInch), "+2");
  EXPECT_EQ(legend_number(0.003, LengthDisplay::kFeetInch),
            "+0.118");  // 3 mm is no 32nd: not called 1/8
}

TEST(LegendStep, IsRoundAndLeavesFewNumbers) {
  EXPECT_NEAR(legend_step(0.010, LengthDisplay::kMillimetre), 0.005, 1e-12);
  EXPECT_NEAR(legend_step(0.004, LengthDisplay::kMillimetre), 0.001, 1e-12);
  EXPECT_NEAR(legend_step(0.030, LengthDisplay::kMillimetre), 0.010, 1e-12);
  EXPECT_NEAR(legend_step(0.010, LengthDisplay::kFeetInch), 0.0254 / 8, 1e-12);
  for (double range = 0.0005; range < 2; range *= 1.3) {
    for (const auto units : {LengthDisplay::kMillimetre, LengthDisplay::kFeetInch}) {
      const double count = range / legend_step(range, units);
      EXPECT_LE(count, 4 + 1e-9);
      EXPECT_GE(count, 0.3);
    }
  }
}

class Legend : public ::testing::Test {
 protected:
  void SetUp() override {
    auto font = FontAtlas::make(legend_text_px(1));
    ASSERT_TRUE(font);
    font_ = std::move(*font);
  }
  [[nodiscard]] Canvas draw(const LegendContent& content, int height = 600) const {
    return draw_legend(content, 800, height, 1, font_);
  }
  static bool says(const Canvas& canvas, const std::string& text) {
    return std::ranges::any_of(canvas.texts, [&](const CanvasText& t) { return t.utf8 == text; });
  }
  FontAtlas font_;
};

TEST_F(Legend, SaysTheUnitAndBothSidesAndTheTolerance) {
  const Canvas canvas = draw({});
  EXPECT_TRUE(says(canvas, "Deviation, mm"));
  EXPECT_TRUE(says(canvas, "outside") && says(canvas, "inside"));
  EXPECT_TRUE(says(canvas, "+3") && says(canvas,
                                         "\xE2\x88\x92"
                                         "3"));
  EXPECT_TRUE(says(canvas,
                   "\xC2\xB1"
                   "3 tolerance"));
  EXPECT_TRUE(says(draw({.units = LengthDisplay::kFeetInch}), "Deviation, inch"));
}

TEST_F(Legend, NamesOtherPointsOnlyWhereTheyAreShown) {
  EXPECT_FALSE(says(draw({}), "contradicts design"));
  EXPECT_TRUE(says(draw({.has_contradicting = true}), "contradicts design"));
  EXPECT_FALSE(says(draw({}), "other things"));
  EXPECT_TRUE(says(draw({.has_clutter = true}), "other things"));
}

TEST_F(Legend, BarHasTheColourOfTheValueAtEachHeight) {
  const Canvas canvas = draw({});
  const auto y_of = [&](const std::string& text) {
    const auto found =
        std::ranges::find_if(canvas.texts, [&](const auto& t) { return t.utf8 == text; });
    return found->at.y();
  };
  const float top = y_of("+10");
  const float bottom = y_of(
      "\xE2\x88\x92"
      "10");
  int rows = 0;
  for (const CanvasShape& s : canvas.shapes) {
    if (s.half_size.y() != 0.5F || s.half_size.x() < 5) continue;
    const double value = 0.010 - 0.020 * (s.centre.y() - top) / (bottom - top);
    const Eigen::Vector3f expected = deviation_colour(value, 0.001, 0.010);
    EXPECT_LT((s.fill.head<3>() - expected).norm(), 0.01F) << value;
    ++rows;
  }
  EXPECT_EQ(rows, static_cast<int>(bottom - top + 0.5F));
}

TEST_F(Legend, NumbersNeverTouch) {
  for (const double tolerance : {0.0005, 0.001, 0.003, 0.0049, 0.0095}) {
    const Canvas canvas =
        draw({.tolerance_m = tolerance, .has_clutter = true, .has_contradicting = true}, 400);
    for (const CanvasText& a : canvas.texts) {
      for (const CanvasText& b : canvas.texts) {
        if (&a == &b) continue;
        EXPECT_GE(std::abs(a.at.y() - b.at.y()), 14) << a.utf8 << " and " << b.utf8;
      }
    }
  }
}

TEST_F(Legend, FitsItsPanelIntoThePicture) {
  for (const int height : {360, 600, 1200}) {
    for (const CanvasShape& s :
         draw({.has_clutter = true, .has_contradicting = true}, height).shapes) {
      EXPECT_GE(s.centre.y() - s.half_size.y(), 0) << height;
      EXPECT_LE(s.centre.y() + s.half_size.y(), height) << height;
    }
  }
}

}  // namespace
}  // namespace spool::render
