// A picture on the graphics card, for panels to show.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "render/gl_handle.h"
#include "render/image.h"
#include "vision/core/result.h"

namespace spool::render {

// GL thread only; gone before its context.
class ImageTexture {
 public:
  ImageTexture() = default;
  // kBadInput: an empty picture; kInternal where the driver does not take it.
  [[nodiscard]] static Result<ImageTexture> create(const Image& image);

  [[nodiscard]] std::uint64_t id() const { return texture_.id(); }  // 0: none
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  TextureHandle texture_;
  int width_ = 0, height_ = 0;
};

}  // namespace spool::render
