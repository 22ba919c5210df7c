// Pass: the design's outline and creases as lines; fainter where something stands before them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/edge_pass.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "render/gl_state.h"

namespace spool::render {
namespace {

const Eigen::Vector3f kLitLine{0.45F, 0.82F, 1.00F};  // sRGB
constexpr float kOpacity = 0.92F;
constexpr float kHiddenOpacity = 0.22F;
constexpr float kHiddenLitOpacity = 0.6F;

struct LineInstance {
  Eigen::Vector3f from;  // m, design frame
  Eigen::Vector3f to;
  float lit = 0;
};

}  // namespace

Result<EdgePass> EdgePass::create() {
  auto program = ShaderProgram::create("edge");
  if (!program) return program.error();
  EdgePass pass;
  pass.program_ = std::move(*program);
  pass.instances_ = make_buffer();
  pass.attributes_ = make_vertex_array();
  glBindVertexArray(pass.attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pass.instances_.id());
  const auto attribute = [](GLuint at, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(at);
    glVertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, sizeof(LineInstance),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(at, 1);
  };
  attribute(0, 3, offsetof(LineInstance, from));
  attribute(1, 3, offsetof(LineInstance, to));
  attribute(2, 1, offsetof(LineInstance, lit));
  return pass;
}

void EdgePass::set_edges(std::vector<MeshEdge> creases, std::vector<MeshEdge> smooth) {
  creases_ = std::move(creases);
  smooth_ = std::move(smooth);
}

void EdgePass::draw(const Offscreen& target, const View& view, const std::array<int, 2>& lit_parts,
                    float width_px, double tolerance_m, const EdgeColours& colours) {
  // The outline depends on the eye. Found here in well under a millisecond for 100 000 triangles;
  // in a vertex shader every edge would cost four invocations, which a software driver cannot
  // afford.
  const Eigen::Vector3f eye = view.T_camera_design.inverse().translation().cast<float>();
  outline_.clear();
  append_outline(smooth_, eye, outline_);
  // A lit part shows through what stands before it, outline and all; of other parts only the
  // creases, fainter: an outline behind something is the outline of something unseen.
  const auto is_lit = [&lit_parts](const MeshEdge& edge) {
    return std::any_of(lit_parts.begin(), lit_parts.end(), [&edge](int part) {
      return part >= 0 && (edge.part == part || edge.other_part == part);
    });
  };
  const auto not_lit = std::partition(outline_.begin(), outline_.end(), is_lit);
  const auto seen_through =
      static_cast<GLsizei>(creases_.size()) + static_cast<GLsizei>(not_lit - outline_.begin());
  std::vector<LineInstance> lines;
  lines.reserve(creases_.size() + outline_.size());
  for (const auto* edges : {&creases_, &outline_}) {
    for (const MeshEdge& edge : *edges) {
      lines.push_back({edge.from, edge.to, is_lit(edge) ? 1.0F : 0.0F});
    }
  }
  if (lines.empty()) return;

  target.bind();
  program_.use();
  program_.set("u_eye_from_design", eye_from_design(view));
  program_.set("u_clip_from_eye", clip_from_eye(view));
  program_.set("u_picture_px", Eigen::Vector2f(static_cast<float>(target.width()),
                                               static_cast<float>(target.height())));
  program_.set("u_near_m", static_cast<float>(view.near_m));
  program_.set("u_shift_m", static_cast<float>(-tolerance_m));
  program_.set("u_colour", colours.line);
  program_.set("u_lit_colour", kLitLine);
  program_.set("u_rim_colour", colours.rim);
  glBindVertexArray(attributes_.id());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lines.size() * sizeof(LineInstance)),
               lines.data(), GL_STREAM_DRAW);
  if (seen_through > 0 && colours.shows_hidden) {
    set_draw_state({.blend = Blend::kOver, .depth_test = DepthTest::kFarther});
    program_.set("u_width_px", 0.7F * width_px);
    program_.set("u_opacity", kHiddenOpacity);
    program_.set("u_lit_opacity", kHiddenLitOpacity);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, seen_through);
  }
  set_draw_state({.blend = Blend::kOver, .depth_test = DepthTest::kNearerOrEqual});
  program_.set("u_width_px", width_px);
  program_.set("u_opacity", kOpacity);
  program_.set("u_lit_opacity", 1.0F);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
}

}  // namespace spool::render
