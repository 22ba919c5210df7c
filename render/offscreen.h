// The target that every picture is drawn to first: colour and depth, window or not.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/gl_handle.h"
#include "render/image.h"
#include "vision/core/result.h"

namespace spool::render {

// RGBA8 and 24-bit depth of one size. GL thread only.
class Offscreen {
 public:
  Offscreen() = default;
  // kBadInput where the size is not 1 to 16384 px a side or more than the driver allows; kNoDevice
  // where the driver refuses such a target.
  [[nodiscard]] static Result<Offscreen> create(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  void bind() const;         // framebuffer and viewport
  void bind_colour() const;  // the same without depth, which can then be read as depth_texture()
  [[nodiscard]] GLuint depth_texture() const { return depth_.id(); }
  [[nodiscard]] Image read() const;
  // Copies its colours into a part of another target, top left corner at (x, y) px; what lies
  // outside is left out.
  void copy_to(const Offscreen& other, int x, int y) const;
  void show(int width, int height) const;  // copies it to the window's framebuffer (0) of that size

 private:
  FramebufferHandle framebuffer_;
  FramebufferHandle colour_framebuffer_;
  TextureHandle colour_;
  TextureHandle depth_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace spool::render
