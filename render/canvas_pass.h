// Pass: a canvas of boxes, triangles and text over the picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "render/canvas.h"
#include "render/font_atlas.h"
#include "render/offscreen.h"
#include "render/shader.h"
#include "vision/core/result.h"

namespace spool::render {

class CanvasPass {
 public:
  [[nodiscard]] static Result<CanvasPass> create();
  [[nodiscard]] Status draw(const Offscreen& target, const Canvas& canvas);
  // The font at a size, set on first use; sizes are whole pixels.
  [[nodiscard]] Result<const FontAtlas*> font(float size_px);

 private:
  struct Font {
    FontAtlas atlas;
    TextureHandle texture;
  };
  [[nodiscard]] Result<const Font*> load(float size_px);
  void draw_shapes(const Canvas& canvas, const Eigen::Vector2f& picture_px) const;
  [[nodiscard]] Status draw_texts(const Canvas& canvas, const Eigen::Vector2f& picture_px);

  ShaderProgram shape_;
  ShaderProgram text_;
  BufferHandle shape_buffer_;
  BufferHandle text_buffer_;
  VertexArrayHandle shape_attributes_;
  VertexArrayHandle text_attributes_;
  std::map<int, Font> fonts_;  // by size in px
};

}  // namespace spool::render
