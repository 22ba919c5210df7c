// Pass: the design's body as tinted glass, hidden by points that stand before it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_pass.h"

#include <cstddef>
#include <utility>

#include "render/gl_state.h"

namespace spool::render {
namespace {

const Eigen::Vector3f kBody{0.66F, 0.71F, 0.76F};     // sRGB; neutral: hues belong to deviations
const Eigen::Vector3f kLitBody{0.34F, 0.71F, 0.91F};  // sRGB; the sky blue of the next part
constexpr float kOpacity = 0.34F;

}  // namespace

Result<MeshPass> MeshPass::create() {
  auto program = ShaderProgram::create("mesh");
  if (!program) return program.error();
  auto lay_over = ShaderProgram::create("layer");
  if (!lay_over) return lay_over.error();
  MeshPass pass;
  pass.lay_over_ = std::move(*lay_over);
  pass.no_attributes_ = make_vertex_array();
  pass.layer_framebuffer_ = make_framebuffer();
  pass.program_ = std::move(*program);
  pass.vertices_ = make_buffer();
  pass.indices_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  glBindVertexArray(pass.attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pass.vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pass.indices_.id());
  const auto attribute = [](GLuint at, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(MeshVertex, position));
  attribute(1, 3, offsetof(MeshVertex, normal));
  attribute(2, 1, offsetof(MeshVertex, part));
  return pass;
}

void MeshPass::set_mesh(const MeshGeometry& geometry) {
  glBindVertexArray(attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(geometry.vertices.size() * sizeof(MeshVertex)),
               geometry.vertices.data(), GL_STATIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(geometry.indices.size() * sizeof(std::uint32_t)),
               geometry.indices.data(), GL_STATIC_DRAW);
  index_count_ = static_cast<GLsizei>(geometry.indices.size());
  is_solid_ = geometry.is_solid;
}

void MeshPass::resize_layer(const Offscreen& target) {
  if (layer_width_ == target.width() && layer_height_ == target.height()) return;
  layer_width_ = target.width();
  layer_height_ = target.height();
  layer_ = make_texture();
  glBindTexture(GL_TEXTURE_2D, layer_.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, layer_width_, layer_height_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void MeshPass::draw(const Offscreen& target, const View& view, const std::array<int, 2>& lit_parts,
                    double tolerance_m) {
  if (index_count_ == 0) return;
  resize_layer(target);
  glBindFramebuffer(GL_FRAMEBUFFER, layer_framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer_.id(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth_texture(),
                         0);
  glViewport(0, 0, layer_width_, layer_height_);
  set_draw_state(
      {.depth_test = DepthTest::kNearer, .depth_write = true, .cull_back_faces = is_solid_});
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  program_.use();
  program_.set("u_eye_from_design", eye_from_design(view));
  program_.set("u_clip_from_eye", clip_from_eye(view));
  program_.set("u_shift_m", static_cast<float>(tolerance_m));
  program_.set("u_lit_parts",
               Eigen::Vector2f(static_cast<float>(lit_parts[0]), static_cast<float>(lit_parts[1])));
  program_.set("u_colour", kBody);
  program_.set("u_lit_colour", kLitBody);
  program_.set("u_opacity", kOpacity);
  glBindVertexArray(attributes_.id());
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  // Let go of the target's depth: it may be gone before the next draw.
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);

  target.bind();
  set_draw_state({.blend = Blend::kOver});
  lay_over_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, layer_.id());
  lay_over_.set("u_layer", 0);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace spool::render
