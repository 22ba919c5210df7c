// Pass: the design's body as tinted glass, hidden by points that stand before it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "render/mesh_geometry.h"
#include "render/offscreen.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/result.h"

namespace spool::render {

class MeshPass {
 public:
  [[nodiscard]] static Result<MeshPass> create();
  void set_mesh(const MeshGeometry& geometry);
  // Nearest surface only. Points up to `tolerance_m` behind the surface stay before it: the steel
  // as measured is what the picture is about. Writes depth.
  void draw(const Offscreen& target, const View& view, const std::array<int, 2>& lit_parts,
            double tolerance_m);

 private:
  void resize_layer(const Offscreen& target);

  ShaderProgram program_;
  ShaderProgram lay_over_;
  VertexArrayHandle no_attributes_;
  // The body alone, drawn opaque against the target's depth: of panes behind one another only the
  // nearest is kept, with the triangles sent once.
  FramebufferHandle layer_framebuffer_;
  TextureHandle layer_;
  int layer_width_ = 0;
  int layer_height_ = 0;
  BufferHandle vertices_;
  BufferHandle indices_;
  VertexArrayHandle attributes_;
  GLsizei index_count_ = 0;
  bool is_solid_ = false;
};

}  // namespace spool::render
