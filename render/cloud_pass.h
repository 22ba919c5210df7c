// Pass: the measured points, coloured by deviation; clutter dim, what contradicts marked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "render/offscreen.h"
#include "render/shader.h"
#include "render/view.h"
#include "vision/core/result.h"

namespace spool::render {

struct CloudStyle {
  double neutral_m = 0.001;  // m; half width of the grey band
  double range_m = 0.010;    // m; the ends of the colours
  float size_px = 3.0F;
  double spacing_m =
      0;  // m; points grow so that a surface sampled so closely has no holes; 0: fixed size
  bool show_clutter = true;
};

// How points of any pass look: sizes, and the colours of deviations (deviation_colour.glsl), to a
// program in use. `largest_px`: what the driver draws.
void set_point_look(const ShaderProgram& program, const View& view, const CloudStyle& style,
                    float largest_px);
[[nodiscard]] float largest_point_px();

class CloudPass {
 public:
  [[nodiscard]] static Result<CloudPass> create();
  // As OverlayRenderer::set_points.
  void set_points(std::span<const Eigen::Vector3f> points_design,
                  std::span<const float> deviation_m, std::span<const std::uint8_t> classes);
  [[nodiscard]] bool has_clutter() const { return count_[0] > 0; }
  [[nodiscard]] bool has_contradicting() const { return count_[3] > 0; }
  // Colour and depth of the points.
  void draw(const Offscreen& target, const View& view, const CloudStyle& style) const;

 private:
  ShaderProgram points_;
  ShaderProgram discs_;
  ShaderProgram contradicting_;
  BufferHandle buffer_;
  VertexArrayHandle attributes_;
  // The buffer holds clutter, points of unknown deviation, the object, and what contradicts the
  // design.
  std::array<GLsizei, 4> count_{};
  float largest_px_ = 1;  // what the driver draws
};

}  // namespace spool::render
