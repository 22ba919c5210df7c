// A picture in memory: 8-bit RGBA, row 0 at the top.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"

namespace spool::render {

struct Image {
  int width = 0;                   // px
  int height = 0;                  // px
  std::vector<std::uint8_t> rgba;  // width * height * 4

  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
    return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x));
  }
};

// PNG bytes of an image; kInternal only where libpng fails.
[[nodiscard]] Result<std::string> encode_png(const Image& image);
// kBadInput for anything that is not a whole PNG of at most 16384 px a side.
[[nodiscard]] Result<Image> decode_png(std::string_view bytes);
[[nodiscard]] Status write_png(const std::filesystem::path& path, const Image& image);
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& path);

}  // namespace spool::render
