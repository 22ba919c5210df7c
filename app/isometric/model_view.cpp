// The shaded view of a design with the line drawing's labels at what they name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/isometric/model_view.h"

#include <algorithm>
#include <cmath>

#include "app/isometric/page_parts.h"
#include "render/egl_context.h"
#include "render/model_picture.h"
#include "vision/guide/centre_line.h"
#include "vision/guide/isometric_layout.h"

namespace spool::isometric {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPixels_mm = 7;     // pixels a millimetre: 178 dpi
constexpr double kFill = 0.80;       // of the area; labels stand round the steel
constexpr double kFieldOfView = 12;  // degrees: nearly square to the drawing, with some depth
constexpr float kLine_px = 2;

// The picture's scale on the page.
Vector2d on_page(const render::View& view, const Vector3d& p_design) {
  const render::Projected at = render::project(view, p_design);
  return model_area().min() + Vector2d(at.x + 0.5, at.y + 0.5) / kPixels_mm;
}

// The same direction, cut to the steel.
render::View cut_to(render::View view, const TriangleMesh& mesh) {
  Eigen::AlignedBox2d extent;
  for (const auto& vertex : mesh.vertices) {
    const render::Projected at = render::project(view, vertex.cast<double>());
    extent.extend(Vector2d(at.x, at.y));
  }
  if (extent.isEmpty() || extent.sizes().maxCoeff() < 1) return view;
  Camera& camera = view.camera;
  const Vector2d room(camera.width, camera.height);
  const double zoom = kFill * room.cwiseQuotient(extent.sizes().cwiseMax(1.0)).minCoeff();
  camera.fx *= zoom;
  camera.fy *= zoom;
  camera.cx = 0.5 * (camera.width - 1) + zoom * (camera.cx - extent.center().x());
  camera.cy = 0.5 * (camera.height - 1) + zoom * (camera.cy - extent.center().y());
  return view;
}

// The steel as lines that labels keep off: centre lines and both sides of each pipe.
std::vector<guide::LineToAvoid> steel_lines(const DesignModel& design,
                                            const guide::Compass& compass,
                                            const render::View& view) {
  std::vector<guide::LineToAvoid> lines;
  const auto line = guide::centre_line(design, compass);
  if (!line) return lines;
  Eigen::Matrix3d axes;
  axes << compass.east.transpose(), compass.north.transpose(), compass.up.transpose();
  for (const guide::LineEdge& edge : line->edges) {
    const auto place = [&](int node) {
      return Vector3d(axes.transpose() * line->nodes[static_cast<std::size_t>(node)].place -
                      design.origin);
    };
    const Vector2d a = on_page(view, place(edge.from)), b = on_page(view, place(edge.to));
    lines.push_back({{a, b}, 2});
    const Part& part = design.parts[static_cast<std::size_t>(edge.part)];
    const double depth = render::project(view, place(edge.from)).depth_m;
    const double radius_mm = 0.5 * 0.0254 * 1.1 * std::max(part.nps, 0.5) * view.camera.fx /
                             std::max(depth, 1e-3) / kPixels_mm;
    if ((b - a).norm() < 1e-6) continue;
    const Vector2d along = (b - a).normalized(), side = radius_mm * Vector2d(-along.y(), along.x());
    for (const double share : {1.0, 0.5, -0.5, -1.0})
      lines.push_back({{a + share * side, b + share * side}, 1});
  }
  return lines;
}

}  // namespace

guide::Box2 model_area() {
  return {
      Vector2d(kMargin_mm + 1, kMargin_mm + 1),
      Vector2d(kPageWidth_mm - kMargin_mm - 1, kPageHeight_mm - kMargin_mm - kBlockHeight_mm - 1)};
}

ModelPicture draw_model_view(const DesignModel& design, int quarter,
                             const guide::IsometricOptions& options) {
  ModelPicture picture;
  if (design.mesh.triangles.empty()) {
    picture.why_none = "There is no shaded view: the design has no surface.";
    return picture;
  }
  const guide::Compass& compass = options.compass;
  const Vector3d eye = guide::towards_eye(quarter);
  const Vector3d towards = eye.x() * compass.east + eye.y() * compass.north + eye.z() * compass.up;
  const Vector2d size = kPixels_mm * model_area().sizes();
  const render::View view =
      cut_to(render::view_of(design.bounds(), -towards, compass.up, static_cast<int>(size.x()),
                             static_cast<int>(size.y()), kFieldOfView),
             design.mesh);
  const auto context = render::EglContext::surfaceless();
  if (!context) {
    picture.why_none = "There is no shaded view: " + context.error().message;
    return picture;
  }
  auto image = render::draw_model(design.mesh, design.triangle_part, view, kLine_px);
  if (!image) {
    picture.why_none = "There is no shaded view: " + image.error().message;
    return picture;
  }
  picture.image = std::move(*image);
  std::vector<guide::LabelRequest> requests;
  for (guide::DrawingLabel& each : guide::weld_and_part_labels(design)) {
    requests.push_back({on_page(view, each.place), guide::label_half_size(each, options), false,
                        Vector2d::Zero()});
    picture.labels.push_back({std::move(each), {}});
  }
  const auto placed =
      guide::place_labels(requests, steel_lines(design, compass, view), {}, model_area());
  for (std::size_t k = 0; k < placed.size(); ++k) {
    picture.labels[k].placed = placed[k];
    if (!placed[k].is_placed) ++picture.labels_without_place;
  }
  return picture;
}

}  // namespace spool::isometric
