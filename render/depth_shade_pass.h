// Pass: darkens the points where nearer ones stand beside them, so that their form can be read.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/offscreen.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/result.h"

namespace spool::render {

class DepthShadePass {
 public:
  [[nodiscard]] static Result<DepthShadePass> create();
  // After the points, drawn `point_px` large or larger to close gaps of `spacing_m` (0: none), and
  // before anything that should keep its colour.
  void draw(const Offscreen& target, const View& view, float point_px, double spacing_m) const;

 private:
  ShaderProgram program_;
  VertexArrayHandle no_attributes_;
};

}  // namespace spool::render
