// Numbered marks on the picture for proposed and picked points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/markers.h"

#include <numbers>

namespace spool::render {
namespace {

const Eigen::Vector3f kSkyBlue{0.34F, 0.71F, 0.91F};  // sRGB
const Eigen::Vector3f kWhite{1.0F, 1.0F, 1.0F};
const Eigen::Vector3f kAmber{0.94F, 0.71F, 0.16F};
const Eigen::Vector3f kInk{0.05F, 0.06F, 0.08F};

Eigen::Vector3f colour_of(Marker::Kind kind) {
  switch (kind) {
    case Marker::Kind::kProposed:
      return kSkyBlue;
    case Marker::Kind::kPicked:
      return kWhite;
    case Marker::Kind::kScan:
      break;
  }
  return kAmber;
}

// Everything about one mark: sizes in px, the ink under it so that it shows on any ground.
struct Mark {
  Eigen::Vector2f at;
  float scale = 1;
  Eigen::Vector3f colour;
  Canvas* canvas = nullptr;

  // A box aside of the middle; first its ink, a pixel larger, then itself.
  void box(const Eigen::Vector2f& aside, const Eigen::Vector2f& half, float corner, float turn,
           bool ink) const {
    CanvasShape shape;
    shape.centre = at + scale * aside;
    shape.half_size = scale * half + Eigen::Vector2f::Constant(ink ? scale : 0.0F);
    shape.corner_px = scale * (corner > 0 ? corner + (ink ? 1.0F : 0.0F) : 0.0F);
    shape.turn_rad = turn;
    shape.fill = ink ? with_opacity(kInk, 0.75F) : with_opacity(colour, 1.0F);
    canvas->shapes.push_back(shape);
  }
  void outline(float half, float corner, float turn) const {
    CanvasShape shape;
    shape.centre = at;
    shape.turn_rad = turn;
    const auto ring = [&](float grow, float border, const Eigen::Vector4f& ink) {
      shape.half_size = Eigen::Vector2f::Constant(scale * (half + grow));
      shape.corner_px = scale * (corner > 0 ? corner + grow : 0);
      shape.border_px = scale * border;
      shape.border = ink;
      shape.fill = with_opacity(ink.head<3>(), 0.0F);
      canvas->shapes.push_back(shape);
    };
    ring(1.0F, 4.5F, with_opacity(kInk, 0.75F));
    ring(0.0F, 2.5F, with_opacity(colour, 1.0F));
  }
  void cross() const {
    for (const bool ink : {true, false}) {
      box(Eigen::Vector2f::Zero(), {6.0F, 1.0F}, 0, 0, ink);
      box(Eigen::Vector2f::Zero(), {1.0F, 6.0F}, 0, 0, ink);
    }
  }
  void ticks() const {
    for (const bool ink : {true, false}) {
      for (const float side : {-1.0F, 1.0F}) {
        box({16 * side, 0}, {4, 1.25F}, 0, 0, ink);
        box({0, 16 * side}, {1.25F, 4}, 0, 0, ink);
      }
      box({0, 0}, {1.5F, 1.5F}, 1.5F, 0, ink);
    }
  }
  void badge(const std::string& label) const {
    const Eigen::Vector2f aside(19, -19);
    for (const bool ink : {true, false}) box(aside, {10, 10}, 10, 0, ink);
    CanvasText text;
    text.utf8 = label;
    text.align = CanvasText::Align::kCentre;
    text.at = at + scale * aside;
    text.size_px = 15 * scale;
    text.colour = with_opacity(kInk, 1.0F);
    canvas->texts.push_back(text);
  }
};

}  // namespace

Canvas draw_markers(std::span<const Marker> markers, const View& view, double scale) {
  Canvas canvas;
  for (const Marker& marker : markers) {
    const Projected p = project(view, marker.position.cast<double>());
    if (!(p.depth_m > 0) || !(p.x > -64 && p.x < view.camera.width + 64) ||
        !(p.y > -64 && p.y < view.camera.height + 64)) {
      continue;
    }
    // A pixel's centre is at integer coordinates in an image, half a pixel on in the canvas.
    const Eigen::Vector2f at(static_cast<float>(p.x + 0.5), static_cast<float>(p.y + 0.5));
    const Mark mark{at, static_cast<float>(scale), colour_of(marker.kind), &canvas};
    switch (marker.kind) {
      case Marker::Kind::kProposed:
        mark.outline(13, 13, 0);
        mark.ticks();
        break;
      case Marker::Kind::kPicked:
        mark.outline(13, 13, 0);
        mark.cross();
        break;
      case Marker::Kind::kScan:
        mark.outline(12, 0, 0.25F * std::numbers::pi_v<float>);
        mark.cross();
        break;
    }
    if (!marker.label.empty()) mark.badge(marker.label);
  }
  return canvas;
}

}  // namespace spool::render
