// Pass: every pixel of a depth image as a point, coloured by its distance to the design in a
// volume.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "render/cloud_pass.h"
#include "render/distance_textures.h"
#include "render/offscreen.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/camera.h"
#include "vision/core/pose.h"

namespace spool::render {

// One depth image and what is drawn of it.
struct DepthPoints {
  std::span<const std::uint16_t> depth;  // counts of the camera's unit, row by row; 0: none
  Camera camera;                         // the image's
  Pose T_design_camera = Pose::Identity();
  // Further from the surface than `facing_beyond_m` (m) a point is the object's only where the
  // surface is turned to the camera: cosine to the line of sight at least `facing_cosine`.
  double facing_beyond_m = 0;
  double facing_cosine = 0;
};

class DepthCloudPass {
 public:
  [[nodiscard]] static Result<DepthCloudPass> create();
  // As OverlayRenderer::set_distances.
  [[nodiscard]] Status set_distances(const DistanceVolume& volume) {
    return distances_.set(volume);
  }
  [[nodiscard]] bool has_distances() const { return distances_.is_set(); }
  void set_depth(const DepthPoints& points);
  // Colour and depth of the points, as CloudPass draws them; clutter is what the volume does not
  // know. After set_distances() and set_depth().
  void draw(const Offscreen& target, const View& view, const CloudStyle& style) const;

 private:
  ShaderProgram points_;
  ShaderProgram discs_;
  DistanceTextures distances_;
  TextureHandle depth_;
  VertexArrayHandle no_attributes_;
  DepthPoints shown_;  // without its depth, which is in the texture
  float largest_px_ = 1;
};

}  // namespace spool::render
