// Pass: marks on the design of how well each patch of it is known, told apart by their shape.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "render/offscreen.h"
#include "render/overlay.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/result.h"

namespace spool::render {

class PatchPass {
 public:
  [[nodiscard]] static Result<PatchPass> create();
  void set_patches(std::span<const PatchMark> patches);
  // Those that face the eye, before a design body that was drawn `tolerance_m` farther away.
  void draw(const Offscreen& target, const View& view, double tolerance_m) const;

 private:
  ShaderProgram program_;
  BufferHandle instances_;
  VertexArrayHandle attributes_;
  GLsizei count_ = 0;
};

}  // namespace spool::render
