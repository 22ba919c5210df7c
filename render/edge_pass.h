// Pass: the design's outline and creases as lines; fainter where something stands before them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "render/mesh_geometry.h"
#include "render/offscreen.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/result.h"

namespace spool::render {

// sRGB. The default is for the dark screen; on paper lines are dark, and hidden ones left out.
struct EdgeColours {
  Eigen::Vector3f line{0.90F, 0.94F, 0.97F};
  Eigen::Vector3f rim{0.03F, 0.04F, 0.05F};
  bool shows_hidden = true;
};

class EdgePass {
 public:
  [[nodiscard]] static Result<EdgePass> create();
  void set_edges(std::vector<MeshEdge> creases, std::vector<MeshEdge> smooth);
  // Lines count as hidden by what is more than `tolerance_m` nearer.
  void draw(const Offscreen& target, const View& view, const std::array<int, 2>& lit_parts,
            float width_px, double tolerance_m, const EdgeColours& colours = {});

 private:
  ShaderProgram program_;
  BufferHandle instances_;
  VertexArrayHandle attributes_;
  std::vector<MeshEdge> creases_;
  std::vector<MeshEdge> smooth_;
  std::vector<MeshEdge> outline_;  // scratch: of the present view
};

}  // namespace spool::render
