// Type set from the embedded font.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/font_atlas.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace spool::render {
namespace {

FontAtlas font(float size_px) {
  auto made = FontAtlas::make(size_px);
  EXPECT_TRUE(made);
  FontAtlas atlas;
  if (made) atlas = std::move(*made);
  return atlas;
}

TEST(FontAtlas, DigitsAreAllEquallyWide) {
  const FontAtlas atlas = font(28);
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    EXPECT_EQ(atlas.glyph(digit).advance, atlas.glyph(U'0').advance);
  }
  EXPECT_EQ(atlas.width("111"), atlas.width("808"));
}

TEST(FontAtlas, HasTheSignsThatLengthsNeed) {
  const FontAtlas atlas = font(14);
  for (const char32_t code : {U'\u2212', U'\u00B1', U'\u2044', U'\u00B0', U'\u00D8', U'\u2032',
                              U'\u2033', U'\u2078', U'\u2081', U'\u00E4', U'\u00F1'}) {
    EXPECT_NE(&atlas.glyph(code), &atlas.glyph(U'?')) << static_cast<unsigned>(code);
    EXPECT_GT(atlas.glyph(code).width, 0);
  }
  EXPECT_EQ(&atlas.glyph(U'\u4E00'), &atlas.glyph(U'?'));
}

TEST(FontAtlas, GlyphsHaveInk) {
  const FontAtlas atlas = font(20);
  const Glyph& g = atlas.glyph(U'8');
  int darkest = 0;
  for (int y = static_cast<int>(g.top); y < static_cast<int>(g.bottom); ++y) {
    for (int x = static_cast<int>(g.left); x < static_cast<int>(g.right); ++x) {
      darkest = std::max<int>(
          darkest, atlas.coverage()[static_cast<std::size_t>(y * atlas.texture_width() + x)]);
    }
  }
  EXPECT_GT(darkest, 200);
}

TEST(FontAtlas, GrowsWithItsSize) {
  // Two sizes of one outline: capital height is in proportion, to the pixel that boxes are rounded
  // to.
  EXPECT_NEAR(font(56).ascent(), 4 * font(14).ascent(), 4);
  EXPECT_NEAR(font(56).width("Deviation"), 4 * font(14).width("Deviation"), 0.1);
}

TEST(FontAtlas, RefusesSizesThatNoTextureHolds) {
  const auto made = FontAtlas::make(4000);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("4000 px"), std::string::npos) << made.error().message;
}

TEST(CodePoints, DecodeUtf8OfEveryLength) {
  EXPECT_EQ(code_points("a\xC3\xB1\xE2\x88\x92\xF0\x9F\x94\xA7"),
            (std::u32string{U'a', 0xF1, 0x2212, 0x1F527}));
}

TEST(CodePoints, ReplaceBrokenBytesAndGoOn) {
  EXPECT_EQ(code_points("\xFFz"), (std::u32string{0xFFFD, U'z'}));
  EXPECT_EQ(code_points("\xE2\x88z"), (std::u32string{0xFFFD, U'z'}));
  EXPECT_EQ(code_points("\xC3"), (std::u32string{0xFFFD}));
}

}  // namespace
}  // namespace spool::render
