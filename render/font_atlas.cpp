// The embedded font at one size: its glyphs as the coverage of one texture, and how wide text is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/font_atlas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <stb_truetype.h>

#include "render/embedded_files.h"

namespace spool::render {
namespace {

constexpr int kOversample = 2;  // across: glyphs stand at fractions of a pixel

std::vector<int> wanted_codes() {
  std::vector<int> codes;
  for (int code = 0x20; code <= 0x7E; ++code) codes.push_back(code);
  for (int code = 0xA0; code <= 0xFF; ++code) codes.push_back(code);
  for (const int code : {0x2013, 0x2014, 0x2026, 0x2032, 0x2033, 0x2044, 0x2070, 0x2212}) {
    codes.push_back(code);
  }
  for (int code = 0x2074; code <= 0x2079; ++code) codes.push_back(code);  // superscript 4 to 9
  for (int code = 0x2080; code <= 0x2089; ++code) codes.push_back(code);  // subscript 0 to 9
  return codes;
}

struct Packed {
  std::vector<std::uint8_t> coverage;
  std::vector<stbtt_packedchar> glyphs;
  int side = 0;
};

// Packs all glyphs into the smallest square of a power of two that holds them.
Packed pack(const unsigned char* font, float size_px, std::vector<int>& codes) {
  for (int side = 128; side <= 4096; side *= 2) {
    Packed packed{
        std::vector<std::uint8_t>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)),
        std::vector<stbtt_packedchar>(codes.size()), side};
    stbtt_pack_context context{};
    if (stbtt_PackBegin(&context, packed.coverage.data(), side, side, 0, 1, nullptr) == 0) continue;
    stbtt_PackSetOversampling(&context, kOversample, 1);
    stbtt_pack_range range{};
    range.font_size = STBTT_POINT_SIZE(size_px);  // of the em square, as type is measured
    range.array_of_unicode_codepoints = codes.data();
    range.num_chars = static_cast<int>(codes.size());
    range.chardata_for_range = packed.glyphs.data();
    const int fits = stbtt_PackFontRanges(&context, font, 0, &range, 1);
    stbtt_PackEnd(&context);
    if (fits != 0) return packed;
  }
  return {};
}

}  // namespace

Result<FontAtlas> FontAtlas::make(float size_px) {
  assert(size_px >= 1 && "text of at least a pixel");
  const auto file = embedded_file("font.otf");
  assert(file && "the font is embedded by render/CMakeLists.txt");
  const auto* font = reinterpret_cast<const unsigned char*>(file->data());
  stbtt_fontinfo info{};
  if (stbtt_InitFont(&info, font, 0) == 0) {
    return Error{ErrorCode::kInternal,
                 "the font built into the program cannot be read; build it anew"};
  }
  std::vector<int> codes = wanted_codes();
  const Packed packed = pack(font, size_px, codes);
  if (packed.side == 0) {
    return Error{ErrorCode::kInternal, "text of " + std::to_string(std::lround(size_px)) +
                                           " px is too large to set; use a smaller scale"};
  }
  FontAtlas atlas;
  atlas.coverage_ = packed.coverage;
  atlas.width_ = atlas.height_ = packed.side;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (stbtt_FindGlyphIndex(&info, codes[i]) == 0) continue;
    const stbtt_packedchar& p = packed.glyphs[i];
    atlas.glyphs_[static_cast<char32_t>(codes[i])] = {static_cast<float>(p.x0),
                                                      static_cast<float>(p.y0),
                                                      static_cast<float>(p.x1),
                                                      static_cast<float>(p.y1),
                                                      p.xoff,
                                                      p.yoff,
                                                      p.xoff2 - p.xoff,
                                                      p.yoff2 - p.yoff,
                                                      p.xadvance};
  }
  // Tabular figures: numbers that change stay in place.
  float widest = 0;
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    widest = std::max(widest, atlas.glyphs_[digit].advance);
  }
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    Glyph& glyph = atlas.glyphs_[digit];
    glyph.offset_x += 0.5F * (widest - glyph.advance);
    glyph.advance = widest;
  }
  atlas.ascent_ = -atlas.glyphs_[U'H'].offset_y;
  return atlas;
}

const Glyph& FontAtlas::glyph(char32_t code) const {
  const auto found = glyphs_.find(code);
  return found != glyphs_.end() ? found->second : glyphs_.at(U'?');
}

float FontAtlas::width(std::string_view utf8) const {
  float sum = 0;
  for (const char32_t code : code_points(utf8)) sum += glyph(code).advance;
  return sum;
}

std::u32string code_points(std::string_view utf8) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::u32string codes;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i++]);
    const std::size_t more = lead < 0x80    ? 0
                             : lead >= 0xF0 ? 3
                             : lead >= 0xE0 ? 2
                             : lead >= 0xC2 ? 1
                                            : 9;
    if (more == 9 || lead > 0xF4) {
      codes.push_back(kReplacement);
      continue;
    }
    char32_t code = more == 0 ? lead : lead & (0x3FU >> more);
    std::size_t taken = 0;
    for (; taken < more && i < utf8.size(); ++taken, ++i) {
      const auto next = static_cast<unsigned char>(utf8[i]);
      if ((next & 0xC0U) != 0x80U) break;
      code = code << 6U | (next & 0x3FU);
    }
    codes.push_back(taken == more ? code : kReplacement);
  }
  return codes;
}

}  // namespace spool::render
