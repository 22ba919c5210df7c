// Pass: a soft vertical gradient, and the picture and its depth cleared.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/background_pass.h"

#include <utility>

#include "render/gl_state.h"

namespace spool::render {
namespace {

// Dark, so that both ends of the deviation colours stand out; sRGB.
const Eigen::Vector3f kTop{0.145F, 0.160F, 0.185F};
const Eigen::Vector3f kBottom{0.055F, 0.062F, 0.075F};

}  // namespace

Result<BackgroundPass> BackgroundPass::create() {
  auto program = ShaderProgram::create("background");
  if (!program) return program.error();
  BackgroundPass pass;
  pass.program_ = std::move(*program);
  pass.no_attributes_ = make_vertex_array();
  return pass;
}

void BackgroundPass::draw(const Offscreen& target, bool gradient) const {
  target.bind();
  set_draw_state({.depth_write = true});  // also lets the clear write depth
  glClearColor(kBottom.x(), kBottom.y(), kBottom.z(), 1.0F);
  glClearDepthf(1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!gradient) return;
  set_draw_state({});
  program_.use();
  program_.set("u_top", kTop);
  program_.set("u_bottom", kBottom);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace spool::render
