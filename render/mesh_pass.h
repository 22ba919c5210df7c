// Pass: the design's body as tinted glass, hidden by points that stand before it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  void draw(const Offscreen& target, const View& view, int lit_part, double tolerance_m) const;

 private:
  ShaderProgram program_;
  BufferHandle vertices_;
  BufferHandle indices_;
  VertexArrayHandle attributes_;
  GLsizei index_count_ = 0;
};

}  // namespace spool::render
