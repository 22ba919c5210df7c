// Pass: Dear ImGui's draw lists. The one file of render/ that knows ImGui; no ImGui back end is
// used.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/offscreen.h"
#include "render/shader.h"
#include "vision/core/result.h"

struct ImDrawData;

namespace spool::render {

// GL thread only. Textures in the draw lists are GL texture names (ImTextureID holds the number).
class ImguiPass {
 public:
  // Needs a current ImGui context whose fonts are added; builds their atlas where that is not done
  // and takes it to the GPU. Digits get one width in all fonts, so that a changing number does not
  // jump.
  [[nodiscard]] static Result<ImguiPass> create();
  // Again, after fonts were added or their size changed.
  [[nodiscard]] Status upload_fonts();
  // Over what the target holds. Uses ImDrawData's own positions and framebuffer scale.
  [[nodiscard]] Status draw(const Offscreen& target, const ImDrawData& data) const;

 private:
  void set_state(const Offscreen& target, const ImDrawData& data) const;

  ShaderProgram program_;
  BufferHandle vertices_;
  BufferHandle indices_;
  VertexArrayHandle attributes_;
  TextureHandle fonts_;
};

}  // namespace spool::render
