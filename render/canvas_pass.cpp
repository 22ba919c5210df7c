// Pass: a canvas of boxes, triangles and text over the picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/canvas_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "render/gl_state.h"

namespace spool::render {
namespace {

struct ShapeInstance {
  Eigen::Vector4f box;   // px: centre, half size
  Eigen::Vector4f form;  // corner, border, turn, 1: triangle
  Eigen::Vector4f fill;
  Eigen::Vector4f border;
};

struct GlyphInstance {
  Eigen::Vector4f box;      // px
  Eigen::Vector4f texture;  // 0..1
  Eigen::Vector4f colour;
};

// `count` vec4 attributes, one after another, one set an instance.
void instance_attributes(const VertexArrayHandle& attributes, const BufferHandle& buffer,
                         GLuint count) {
  glBindVertexArray(attributes.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  for (GLuint i = 0; i < count; ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(count * sizeof(Eigen::Vector4f)),
                          reinterpret_cast<const void*>(i * sizeof(Eigen::Vector4f)));
    glVertexAttribDivisor(i, 1);
  }
}

template <class Instance>
void draw_instances(const VertexArrayHandle& attributes, const BufferHandle& buffer,
                    const std::vector<Instance>& instances) {
  glBindVertexArray(attributes.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
               instances.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
}

TextureHandle upload(const FontAtlas& atlas) {
  TextureHandle texture = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, atlas.texture_width(), atlas.texture_height());
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, atlas.texture_width(), atlas.texture_height(), GL_RED,
                  GL_UNSIGNED_BYTE, atlas.coverage().data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void append_glyphs(const CanvasText& text, const FontAtlas& atlas,
                   std::vector<GlyphInstance>& glyphs) {
  const float width = atlas.width(text.utf8);
  float pen = text.at.x();
  if (text.align == CanvasText::Align::kCentre) pen -= 0.5F * width;
  if (text.align == CanvasText::Align::kRight) pen -= width;
  // The base line stands on a whole pixel: horizontal strokes stay sharp.
  const float base = std::round(text.at.y() + 0.5F * atlas.ascent());
  const auto w = static_cast<float>(atlas.texture_width());
  const auto h = static_cast<float>(atlas.texture_height());
  for (const char32_t code : code_points(text.utf8)) {
    const Glyph& g = atlas.glyph(code);
    const float left = pen + g.offset_x;
    const float top = base + g.offset_y;
    if (g.width > 0 && g.height > 0) {
      glyphs.push_back({{left, top, left + g.width, top + g.height},
                        {g.left / w, g.top / h, g.right / w, g.bottom / h},
                        text.colour});
    }
    pen += g.advance;
  }
}

}  // namespace

Result<CanvasPass> CanvasPass::create() {
  auto shape = ShaderProgram::create("canvas_shape");
  if (!shape) return shape.error();
  auto text = ShaderProgram::create("canvas_text");
  if (!text) return text.error();
  CanvasPass pass;
  pass.shape_ = std::move(*shape);
  pass.text_ = std::move(*text);
  pass.shape_buffer_ = make_buffer();
  pass.text_buffer_ = make_buffer();
  pass.shape_attributes_ = make_vertex_array();
  pass.text_attributes_ = make_vertex_array();
  instance_attributes(pass.shape_attributes_, pass.shape_buffer_, 4);
  instance_attributes(pass.text_attributes_, pass.text_buffer_, 3);
  return pass;
}

Result<const CanvasPass::Font*> CanvasPass::load(float size_px) {
  const int size = std::max(1, static_cast<int>(std::lround(size_px)));
  auto found = fonts_.find(size);
  if (found == fonts_.end()) {
    auto atlas = FontAtlas::make(static_cast<float>(size));
    if (!atlas) return atlas.error();
    TextureHandle texture = upload(*atlas);
    found = fonts_.emplace(size, Font{std::move(*atlas), std::move(texture)}).first;
  }
  const Font* font = &found->second;
  return font;
}

Result<const FontAtlas*> CanvasPass::font(float size_px) {
  const auto font = load(size_px);
  if (!font) return font.error();
  const FontAtlas* atlas = &(*font)->atlas;
  return atlas;
}

void CanvasPass::draw_shapes(const Canvas& canvas, const Eigen::Vector2f& picture_px) const {
  std::vector<ShapeInstance> instances;
  instances.reserve(canvas.shapes.size());
  for (const CanvasShape& s : canvas.shapes) {
    instances.push_back({{s.centre.x(), s.centre.y(), s.half_size.x(), s.half_size.y()},
                         {s.corner_px, s.border_px, s.turn_rad,
                          s.kind == CanvasShape::Kind::kTriangle ? 1.0F : 0.0F},
                         s.fill,
                         s.border});
  }
  if (instances.empty()) return;
  shape_.use();
  shape_.set("u_picture_px", picture_px);
  draw_instances(shape_attributes_, shape_buffer_, instances);
}

Status CanvasPass::draw_texts(const Canvas& canvas, const Eigen::Vector2f& picture_px) {
  text_.use();
  text_.set("u_picture_px", picture_px);
  text_.set("u_font", 0);
  glActiveTexture(GL_TEXTURE0);
  std::map<const Font*, std::vector<GlyphInstance>> by_font;
  for (const CanvasText& text : canvas.texts) {
    const auto font = load(text.size_px);
    if (!font) return font.error();
    append_glyphs(text, (*font)->atlas, by_font[*font]);
  }
  for (const auto& [font, glyphs] : by_font) {
    if (glyphs.empty()) continue;
    glBindTexture(GL_TEXTURE_2D, font->texture.id());
    draw_instances(text_attributes_, text_buffer_, glyphs);
  }
  return {};
}

Status CanvasPass::draw(const Offscreen& target, const Canvas& canvas) {
  target.bind();
  set_draw_state({.blend = Blend::kOver});
  const Eigen::Vector2f picture_px(static_cast<float>(target.width()),
                                   static_cast<float>(target.height()));
  draw_shapes(canvas, picture_px);
  return canvas.texts.empty() ? Status{} : draw_texts(canvas, picture_px);
}

}  // namespace spool::render
