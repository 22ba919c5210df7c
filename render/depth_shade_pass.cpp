// Pass: darkens the points where nearer ones stand beside them, so that their form can be read.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/depth_shade_pass.h"

#include <algorithm>
#include <utility>

#include "render/gl_state.h"

namespace spool::render {

namespace {

// A surface seen at 60 degrees keeps four fifths of its light: form shows, colours stay what they
// are.
constexpr float kStrength = 0.18F;

}  // namespace

Result<DepthShadePass> DepthShadePass::create() {
  auto program = ShaderProgram::create("depth_shade");
  if (!program) return program.error();
  DepthShadePass pass;
  pass.program_ = std::move(*program);
  pass.no_attributes_ = make_vertex_array();
  return pass;
}

void DepthShadePass::draw(const Offscreen& target, const View& view, float point_px,
                          double spacing_m) const {
  target.bind_colour();  // without depth, which the shader reads
  set_draw_state({.blend = Blend::kMultiply});
  program_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, target.depth_texture());
  program_.set("u_depth", 0);
  program_.set("u_near_m", static_cast<float>(view.near_m));
  program_.set("u_far_m", static_cast<float>(view.far_m));
  program_.set("u_focal_px", static_cast<float>(view.camera.fx));
  program_.set("u_radius_px", std::max(1.0F, 0.5F * point_px));
  program_.set("u_spacing_m", static_cast<float>(spacing_m));
  program_.set("u_strength", kStrength);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  target.bind();
}

}  // namespace spool::render
