// A page of paper: what is drawn is there, once, where it was put.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/page_canvas.h"

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using isometric::PageCanvas;

TEST(PageCanvas, ABoxIsInkWhereItIs) {
  const auto image = isometric::draw_page(
      [](PageCanvas& page) {
        page.stroke({{{100, 100}, {120, 100}, {120, 120}, {100, 120}},
                     0.1,
                     true,
                     guide::Stroke::Fill::kInk});
      },
      25.4);  // a pixel a millimetre
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 420);
  EXPECT_EQ(image->height, 297);
  EXPECT_LT(image->pixel(110, 110)[0], 10);
  EXPECT_GT(image->pixel(90, 110)[0], 250);
  EXPECT_GT(image->pixel(110, 130)[0], 250);
}

TEST(PageCanvas, AnImageKeepsItsColoursAndItsTop) {
  render::Image two{1, 2, {255, 0, 0, 255, 0, 0, 255, 255}};  // red above blue
  const auto image =
      isometric::draw_page([&](PageCanvas& page) { page.image(two, 100, 100, 20, 40); }, 25.4);
  ASSERT_TRUE(image);
  EXPECT_GT(image->pixel(110, 104)[0], 200);
  // Enlarged so much, each pixel runs into its neighbours and the paper.
  EXPECT_LT(image->pixel(110, 104)[2], 100);
  EXPECT_GT(image->pixel(110, 136)[2], 200);
}

TEST(PageCanvas, LongTextIsCutToItsRoom) {
  const std::string text(80, 'W');
  EXPECT_GT(isometric::text_width_mm(text, 2.5), 100);
  const auto image = isometric::draw_page(
      [&](PageCanvas& page) {
        page.text(text, 20, 50, 2.5, isometric::TextAlign::kLeft, false, 40);
      },
      50.8);
  ASSERT_TRUE(image);
  bool is_inked = false;
  for (int x = 0; x < image->width; ++x) {
    for (int y = 90; y < 110; ++y) {
      if (image->pixel(x, y)[0] > 128) continue;
      is_inked = true;
      EXPECT_GE(x, 2 * 20 - 2);
      EXPECT_LE(x, 2 * 60 + 2);
    }
  }
  EXPECT_TRUE(is_inked);
}

TEST(PageCanvas, WidthsGrowWithTheLettersNotByWholeMillimetres) {
  const double one = isometric::text_width_mm("pipe-12", 2),
               two = isometric::text_width_mm("pipe-12", 4);
  EXPECT_NEAR(two, 2 * one, 0.02 * two);  // hinting is off
}

TEST(PageCanvas, WrappedLinesFitTheirRoomAndLoseNoLetter) {
  const std::string text = "Bride à collerette " + std::string(60, 'W') + "\nsecond é <b>&";
  const auto lines = isometric::wrapped_lines(text, 2.5, 40);
  std::string all;
  for (const std::string& each : lines) {
    EXPECT_LE(isometric::text_width_mm(each, 2.5), 40.5) << each;  // a space may hang over
    all += each;
  }
  std::string expected = text;
  std::erase(expected, '\n');
  EXPECT_EQ(all, expected);
  EXPECT_EQ(lines.back(), "second é <b>&");
  EXPECT_TRUE(isometric::wrapped_lines("", 2.5, 40).empty());
}

TEST(PageCanvas, APageIsAsLargeAsAskedFor) {
  const auto image = isometric::draw_page([](PageCanvas&) {}, 25.4, {210, 297});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 210);
  EXPECT_EQ(image->height, 297);
}

TEST(PageCanvas, EqualPagesAreEqualFiles) {
  const isometric::Pages pages{[](PageCanvas& page) { page.text("W1", 20, 20, 3); },
                               [](PageCanvas& page) { page.line(0, 0, 10, 10, 0.5); }};
  const auto one = isometric::draw_pdf(pages, "title"), other = isometric::draw_pdf(pages, "title");
  ASSERT_TRUE(one);
  ASSERT_TRUE(other);
  EXPECT_EQ(*one, *other);
  EXPECT_EQ(one->substr(0, 5), "%PDF-");
}

}  // namespace
}  // namespace spool::test
