// A flat drawing over the picture as plain data: boxes, triangles and text in pixels, y down.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace spool::render {

struct CanvasShape {
  enum class Kind { kBox, kTriangle } kind = Kind::kBox;  // a triangle points up, its box around it
  Eigen::Vector2f centre = Eigen::Vector2f::Zero();       // px
  Eigen::Vector2f half_size = Eigen::Vector2f::Zero();    // px
  float corner_px = 0;
  float border_px = 0;                             // inside the shape's outline
  float turn_rad = 0;                              // clockwise on the screen
  Eigen::Vector4f fill = Eigen::Vector4f::Zero();  // sRGB and opacity
  Eigen::Vector4f border = Eigen::Vector4f::Zero();
};

struct CanvasText {
  std::string utf8;
  enum class Align { kLeft, kCentre, kRight } align = Align::kLeft;
  Eigen::Vector2f at = Eigen::Vector2f::Zero();  // px; y: the middle of the capitals' height
  float size_px = 14;
  Eigen::Vector4f colour = Eigen::Vector4f::Ones();
};

// Drawn in order, the shapes first, the text on them.
struct Canvas {
  std::vector<CanvasShape> shapes;
  std::vector<CanvasText> texts;
};

// sRGB with an opacity.
[[nodiscard]] inline Eigen::Vector4f with_opacity(const Eigen::Vector3f& colour, float opacity) {
  return {colour.x(), colour.y(), colour.z(), opacity};
}

}  // namespace spool::render
