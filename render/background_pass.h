// Pass: a soft vertical gradient, and the picture and its depth cleared.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/offscreen.h"
#include "render/shader.h"
#include "vision/core/result.h"

namespace spool::render {

class BackgroundPass {
 public:
  [[nodiscard]] static Result<BackgroundPass> create();
  // Every pixel opaque and at the greatest depth. Without the gradient: one dark colour.
  void draw(const Offscreen& target, bool gradient) const;

 private:
  ShaderProgram program_;
  VertexArrayHandle no_attributes_;
};

}  // namespace spool::render
