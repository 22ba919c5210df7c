// The coloured overlays of a report, drawn off the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/evidence/picture_points.h"
#include "app/evidence/view_choice.h"
#include "app/evidence/writer.h"
#include "render/offscreen.h"
#include "render/overlay.h"
#include "render/view.h"

namespace spool::evidence {
namespace {

constexpr double kLegend_px = 156;  // the strip at the left that the legend takes at scale 1

// The same place and direction with the picture cut to the design and what contradicts it, beside
// the legend: a box fitted whole leaves much of it empty.
render::View cut_to_steel(render::View view, const DesignModel& model,
                          const PicturePoints& points) {
  constexpr double kFill = 0.88;  // of the room there is; what lies round it helps to place it
  Eigen::AlignedBox2d extent;
  const auto add = [&](const Eigen::Vector3f& point) {
    const auto at = render::project(view, point.cast<double>());
    if (at.depth_m > 0) extent.extend(Eigen::Vector2d(at.x, at.y));
  };
  for (const auto& vertex : model.mesh.vertices) add(vertex);
  for (const auto& point : model.cloud.points)
    if (point.allFinite()) add(point);
  for (std::size_t i = 0; i < points.positions.size(); ++i)
    if (points.classes[i] == static_cast<std::uint8_t>(PointClass::kContradicting))
      add(points.positions[i]);
  if (extent.isEmpty() || extent.sizes().minCoeff() < 1) return view;
  auto& camera = view.camera;
  const double left = camera.width > 4 * kLegend_px ? kLegend_px : 0;
  const Eigen::Vector2d room(camera.width - left, camera.height);
  const Eigen::Vector2d middle(left + 0.5 * (room.x() - 1), 0.5 * (room.y() - 1));
  const double zoom = kFill * room.cwiseQuotient(extent.sizes()).minCoeff();
  camera.fx *= zoom;
  camera.fy *= zoom;
  camera.cx = middle.x() + zoom * (camera.cx - extent.center().x());
  camera.cy = middle.y() + zoom * (camera.cy - extent.center().y());
  return view;
}

render::OverlayStyle style_of(const InspectionRecord& record) {
  render::OverlayStyle style;
  // The grey band is as wide as a point's own uncertainty; the ends of the colours lie beyond the
  // noise. In whole tenths of a millimetre, as the legend says it.
  if (record.noise_m > 0) style.neutral_m = std::ceil(1e4 * record.noise_m) / 1e4;
  style.colour_range_m = std::max(style.colour_range_m, 3 * style.neutral_m);
  style.units =
      record.feet_inches ? render::LengthDisplay::kFeetInch : render::LengthDisplay::kMillimetre;
  return style;
}

}  // namespace

Result<std::vector<OverlayPicture>> draw_overlays(const InspectionRecord& record, int width,
                                                  int height) {
  // A design drawn where it was not found would be a false statement about the steel.
  if (!record.inspection.alignment.found) return std::vector<OverlayPicture>{};
  const auto& model = record.design->model;
  auto renderer = render::OverlayRenderer::create();
  if (!renderer) return renderer.error();
  const auto target = render::Offscreen::create(width, height);
  if (!target) return target.error();
  renderer->set_design(model.mesh, model.triangle_part);
  const PicturePoints points = points_near_design(record.inspection, model.bounds());
  const Eigen::AlignedBox3d bounds = steel_bounds(points, model.bounds());
  auto style = style_of(record);
  style.point_spacing_m = object_spacing(points);
  std::vector<OverlayPicture> pictures;
  for (const auto& choice : choose_views(record, static_cast<double>(width) / height)) {
    const auto view = cut_to_steel(
        render::view_of(bounds, choice.direction, choice.up, width, height), model, points);
    const Eigen::Vector3d eye = view.T_camera_design.inverse().translation();
    const auto reach = static_cast<float>(2 * bounds.diagonal().norm());
    const PicturePoints shown =
        without_hiding_clutter(points, *record.design->surface, eye, reach, style.point_spacing_m);
    renderer->set_points(shown.positions, shown.deviation_m, shown.classes);
    if (const auto status = renderer->draw(*target, view, style); !status) return status.error();
    pictures.push_back(
        {"overlay_" + std::to_string(pictures.size() + 1) + ".png", choice.text, target->read()});
  }
  return pictures;
}

}  // namespace spool::evidence
