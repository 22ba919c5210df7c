// The embedded font at one size: its glyphs as the coverage of one texture, and how wide text is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "vision/core/result.h"

namespace spool::render {

struct Glyph {
  float left = 0;  // px in the atlas
  float top = 0;
  float right = 0;
  float bottom = 0;
  float offset_x = 0;  // px from the pen to the drawn box's left top; y down from the base line
  float offset_y = 0;
  float width = 0;  // px drawn
  float height = 0;
  float advance = 0;  // px to the next pen
};

// Latin-1 and the signs that lengths need: minus, primes, fraction slash, small digits. Digits all
// have one advance. Knows no GL.
class FontAtlas {
 public:
  // Type of `size_px` (the em square, as points are). kInternal where the font cannot be set.
  [[nodiscard]] static Result<FontAtlas> make(float size_px);

  [[nodiscard]] const Glyph& glyph(char32_t code) const;  // a question mark for what the font lacks
  [[nodiscard]] float width(std::string_view utf8) const;  // px
  [[nodiscard]] float ascent() const { return ascent_; }   // px above the base line of capitals
  [[nodiscard]] int texture_width() const { return width_; }
  [[nodiscard]] int texture_height() const { return height_; }
  [[nodiscard]] const std::vector<std::uint8_t>& coverage() const { return coverage_; }

 private:
  std::unordered_map<char32_t, Glyph> glyphs_;
  std::vector<std::uint8_t> coverage_;  // 0..255, row 0 on top
  int width_ = 0;
  int height_ = 0;
  float ascent_ = 0;
};

// The code points of UTF-8 text; U+FFFD for bytes that are none.
[[nodiscard]] std::u32string code_points(std::string_view utf8);

}  // namespace spool::render
