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
  MeshPass pass;
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
}

void MeshPass::draw(const Offscreen& target, const View& view, int lit_part,
                    double tolerance_m) const {
  if (index_count_ == 0) return;
  target.bind();
  program_.use();
  program_.set("u_eye_from_design", eye_from_design(view));
  program_.set("u_clip_from_eye", clip_from_eye(view));
  program_.set("u_shift_m", static_cast<float>(tolerance_m));
  program_.set("u_lit_part", static_cast<float>(lit_part));
  program_.set("u_colour", kBody);
  program_.set("u_lit_colour", kLitBody);
  program_.set("u_opacity", kOpacity);
  glBindVertexArray(attributes_.id());
  // Depth first, then only what is nearest: a pane of glass must not be blended twice.
  set_draw_state({.depth_test = DepthTest::kNearer, .depth_write = true, .colour_write = false});
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  set_draw_state({.blend = Blend::kOver, .depth_test = DepthTest::kNearerOrEqual});
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace spool::render
