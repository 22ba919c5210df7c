// A design as a shaded picture on white paper.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/model_picture.h"

#include <cstddef>

#include "render/edge_pass.h"
#include "render/gl_state.h"
#include "render/gl_status.h"
#include "render/mesh_geometry.h"
#include "render/offscreen.h"
#include "render/shader.h"

namespace spool::render {
namespace {

const Eigen::Vector3f kSteel{0.80F, 0.84F, 0.88F};  // sRGB
constexpr double kEdgeShift_m = 0.003;              // lines stand before the faces they bound

void send(const MeshGeometry& geometry, const BufferHandle& vertices, const BufferHandle& indices) {
  glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(geometry.vertices.size() * sizeof(MeshVertex)),
               geometry.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(geometry.indices.size() * sizeof(std::uint32_t)),
               geometry.indices.data(), GL_STATIC_DRAW);
  const auto attribute = [](GLuint at, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(MeshVertex, position));
  attribute(1, 3, offsetof(MeshVertex, normal));
  attribute(2, 1, offsetof(MeshVertex, part));
}

}  // namespace

Result<Image> draw_model(const TriangleMesh& mesh, std::span<const std::int32_t> triangle_part,
                         const View& view, float line_px) {
  const auto target = Offscreen::create(view.camera.width, view.camera.height);
  if (!target) return target.error();
  const auto program = ShaderProgram::create("mesh", "solid");
  if (!program) return program.error();
  auto edges = EdgePass::create();
  if (!edges) return edges.error();
  MeshGeometry geometry = prepare_mesh(mesh, triangle_part);
  const VertexArrayHandle attributes = make_vertex_array();
  const BufferHandle vertices = make_buffer(), indices = make_buffer();
  glBindVertexArray(attributes.id());
  send(geometry, vertices, indices);

  target->bind();
  set_draw_state({.depth_test = DepthTest::kNearer, .depth_write = true});
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  program->use();
  program->set("u_eye_from_design", eye_from_design(view));
  program->set("u_clip_from_eye", clip_from_eye(view));
  program->set("u_shift_m", 0.0F);
  program->set("u_lit_parts", Eigen::Vector2f(-1, -1));
  program->set("u_colour", kSteel);
  program->set("u_lit_colour", kSteel);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(geometry.indices.size()), GL_UNSIGNED_INT,
                 nullptr);
  edges->set_edges(std::move(geometry.creases), std::move(geometry.smooth));
  edges->draw(*target, view, {-1, -1}, line_px, kEdgeShift_m,
              {.line = {0.10F, 0.12F, 0.15F}, .rim = {0.5F, 0.53F, 0.56F}, .shows_hidden = false});
  Image image = target->read();
  if (const Status status = gl_status("drawing the model"); !status) return status.error();
  return image;
}

}  // namespace spool::render
