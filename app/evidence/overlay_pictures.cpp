// The coloured overlays of a report, drawn off the screen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/evidence/view_choice.h"
#include "app/evidence/writer.h"
#include "render/offscreen.h"
#include "render/overlay.h"
#include "render/view.h"
#include "vision/scan/point_index.h"

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

// Without the clutter that would hide steel in `view`: a table seen from below, a person between.
// What contradicts the design stays whatever it hides.
Points without_hiding_clutter(const Points& all, const DesignSurface& surface,
                              const render::View& view, float reach_m) {
  const Eigen::Vector3f eye = view.T_camera_design.inverse().translation().cast<float>();
  const auto hides = [&](std::size_t i) {
    return all.classes[i] == static_cast<std::uint8_t>(PointClass::kClutter) &&
           surface.cast(all.positions[i], (all.positions[i] - eye).normalized(), reach_m)
               .has_value();
  };
  Points kept;
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    if (hides(i)) continue;
    kept.positions.push_back(all.positions[i]);
    kept.deviation_m.push_back(all.deviation_m[i]);
    kept.classes.push_back(all.classes[i]);
  }
  return kept;
}

// How far the object's points lie apart (m): from the distance d to the fourth neighbour, as four
// points stand for a disc of radius d; the median over some hundreds. 0 where there are too few to
// tell.
double spacing_of(const Points& points) {
  constexpr std::size_t kPlaces = 500;
  constexpr std::size_t kNeighbours = 5;  // the point itself is the first
  constexpr float kReach_m = 0.1F;        // wider apart, no point size makes a surface of them
  std::vector<Eigen::Vector3f> object;
  for (std::size_t i = 0; i < points.positions.size(); ++i)
    if (points.classes[i] != 0) object.push_back(points.positions[i]);
  const PointIndex index(object);
  std::vector<float> distances;
  std::vector<Neighbour> neighbours;
  const std::size_t step = std::max<std::size_t>(1, object.size() / kPlaces);
  for (std::size_t i = 0; i < object.size(); i += step) {
    index.nearest_k(object[i], kNeighbours, kReach_m, neighbours);
    if (neighbours.size() == kNeighbours) distances.push_back(neighbours.back().distance);
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return static_cast<double>(*middle) * std::sqrt(std::numbers::pi / 4);
}

// The same place and direction with the picture cut to the design: a box fitted whole leaves much
// of it empty.
render::View cut_to_design(render::View view, const DesignModel& model) {
  constexpr double kFill = 0.86;  // of the picture; the legend has its strip beside
  Eigen::AlignedBox2d extent;
  const auto add = [&](const Eigen::Vector3f& point) {
    const auto at = render::project(view, point.cast<double>());
    if (at.depth_m > 0) extent.extend(Eigen::Vector2d(at.x, at.y));
  };
  for (const auto& vertex : model.mesh.vertices) add(vertex);
  for (const auto& point : model.cloud.points)
    if (point.allFinite()) add(point);
  if (extent.isEmpty() || extent.sizes().minCoeff() < 1) return view;
  auto& camera = view.camera;
  const double zoom =
      kFill * std::min(camera.width / extent.sizes().x(), camera.height / extent.sizes().y());
  camera.fx *= zoom;
  camera.fy *= zoom;
  camera.cx = 0.5 * (camera.width - 1) + zoom * (camera.cx - extent.center().x());
  camera.cy = 0.5 * (camera.height - 1) + zoom * (camera.cy - extent.center().y());
  return view;
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
  auto style = style_of(record);
  style.point_spacing_m = spacing_of(points);
  std::vector<OverlayPicture> pictures;
  for (const auto& choice : choose_views(record, static_cast<double>(width) / height)) {
    const auto view =
        cut_to_design(render::view_of(bounds, choice.direction, choice.up, width, height), model);
    const auto reach = static_cast<float>(2 * bounds.diagonal().norm());
    const Points shown = without_hiding_clutter(points, *record.design->surface, view, reach);
    renderer->set_points(shown.positions, shown.deviation_m, shown.classes);
    if (const auto status = renderer->draw(*target, view, style); !status) return status.error();
    pictures.push_back(
        {"overlay_" + std::to_string(pictures.size() + 1) + ".png", choice.text, target->read()});
  }
  return pictures;
}

}  // namespace spool::evidence
