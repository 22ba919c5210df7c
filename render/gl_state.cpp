// The whole state of a draw call in one place: every pass sets it at entry, nobody restores.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/gl_state.h"

#include <GLES3/gl3.h>

namespace spool::render {

void set_draw_state(const DrawState& state) {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glFrontFace(GL_CCW);
  glCullFace(GL_BACK);
  if (state.cull_back_faces) {
    glEnable(GL_CULL_FACE);
  } else {
    glDisable(GL_CULL_FACE);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DITHER);  // pictures are the same on every run
  glBlendEquation(GL_FUNC_ADD);
  switch (state.blend) {
    case Blend::kOpaque:
      glDisable(GL_BLEND);
      break;
    case Blend::kOver:
      glEnable(GL_BLEND);
      glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case Blend::kMultiply:
      glEnable(GL_BLEND);
      glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
      break;
  }
  if (state.depth_test == DepthTest::kOff && !state.depth_write) {
    glDisable(GL_DEPTH_TEST);
  } else {
    glEnable(GL_DEPTH_TEST);
  }
  switch (state.depth_test) {
    case DepthTest::kOff:
      glDepthFunc(GL_ALWAYS);
      break;
    case DepthTest::kNearer:
      glDepthFunc(GL_LESS);
      break;
    case DepthTest::kNearerOrEqual:
      glDepthFunc(GL_LEQUAL);
      break;
    case DepthTest::kFarther:
      glDepthFunc(GL_GREATER);
      break;
  }
  const GLboolean colour = state.colour_write ? GL_TRUE : GL_FALSE;
  glColorMask(colour, colour, colour, colour);
  glDepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
}

}  // namespace spool::render
