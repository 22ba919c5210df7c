// Pass: darkens the points where nearer ones stand beside them, so that their form can be read.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/depth_shade_pass.h"

#include <utility>

#include "render/gl_state.h"

namespace spool::render {

Result<DepthShadePass> DepthShadePass::create() {
  auto program = ShaderProgram::create("depth_shade");
  if (!program) return program.error();
  DepthShadePass pass;
  pass.program_ = std::move(*program);
  pass.no_attributes_ = make_vertex_array();
  return pass;
}

void DepthShadePass::draw(const Offscreen& target, const View& view, int radius_px) const {
  target.bind_colour();  // without depth, which the shader reads
  set_draw_state({.blend = Blend::kMultiply});
  program_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, target.depth_texture());
  program_.set("u_depth", 0);
  program_.set("u_near_m", static_cast<float>(view.near_m));
  program_.set("u_far_m", static_cast<float>(view.far_m));
  program_.set("u_radius_px", radius_px);
  program_.set("u_strength", 86.0F);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  target.bind();
}

}  // namespace spool::render
