// The coloured overlays of a report, drawn off the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/evidence/view_choice.h"
#include "app/evidence/writer.h"
#include "render/offscreen.h"
#include "render/overlay.h"
#include "render/view.h"

namespace spool::evidence {
namespace {

// What the renderer takes of one state.
struct Points {
  std::vector<Eigen::Vector3f> positions;
  std::vector<float> deviation_m;
  std::vector<std::uint8_t> classes;
};

// The object's and contradicting points all, clutter only near the design: a wall behind it or in
// front would hide the steel and tells nothing of it.
Points points_to_draw(const Inspection& inspection, const Eigen::AlignedBox3d& bounds) {
  Eigen::AlignedBox3d near = bounds;
  const double margin = 0.15 * bounds.diagonal().norm();
  near.extend(bounds.min() - Eigen::Vector3d::Constant(margin));
  near.extend(bounds.max() + Eigen::Vector3d::Constant(margin));
  const auto& points = inspection.scan_design.points;
  const auto& classes = inspection.declutter.classes;
  Points drawn;
  if (classes.size() != points.size() || inspection.deviations.distance_m.size() != points.size())
    return drawn;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    if (classes[i] == PointClass::kClutter && !near.contains(points[i].cast<double>())) continue;
    drawn.positions.push_back(points[i]);
    drawn.deviation_m.push_back(inspection.deviations.distance_m[i]);
    drawn.classes.push_back(static_cast<std::uint8_t>(classes[i]));
  }
  return drawn;
}

render::OverlayStyle style_of(const InspectionRecord& record) {
  render::OverlayStyle style;
  // The grey band is as wide as a point's own uncertainty; the ends of the colours lie beyond the
  // noise.
  if (record.noise_m > 0) style.neutral_m = record.noise_m;
  style.colour_range_m = std::max(style.colour_range_m, 3 * style.neutral_m);
  style.units =
      record.feet_inches ? render::LengthDisplay::kFeetInch : render::LengthDisplay::kMillimetre;
  return style;
}

}  // namespace

Result<std::vector<OverlayPicture>> draw_overlays(const InspectionRecord& record, int width,
                                                  int height) {
  const auto& model = record.design->model;
  const Eigen::AlignedBox3d bounds = model.bounds();
  auto renderer = render::OverlayRenderer::create();
  if (!renderer) return renderer.error();
  const auto target = render::Offscreen::create(width, height);
  if (!target) return target.error();
  renderer->set_design(model.mesh, model.triangle_part);
  const Points points = points_to_draw(record.inspection, bounds);
  renderer->set_points(points.positions, points.deviation_m, points.classes);
  const auto style = style_of(record);
  std::vector<OverlayPicture> pictures;
  for (const auto& choice : choose_views(record, static_cast<double>(width) / height)) {
    const auto view = render::view_of(bounds, choice.direction, choice.up, width, height);
    if (const auto status = renderer->draw(*target, view, style); !status) return status.error();
    pictures.push_back(
        {"overlay_" + std::to_string(pictures.size() + 1) + ".png", choice.text, target->read()});
  }
  return pictures;
}

}  // namespace spool::evidence
