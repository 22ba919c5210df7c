// The picture: live cloud coloured by deviation, clear design, legend. One state in, pixels out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "render/overlay.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "render/background_pass.h"
#include "render/canvas_pass.h"
#include "render/cloud_pass.h"
#include "render/depth_cloud_pass.h"
#include "render/depth_shade_pass.h"
#include "render/edge_pass.h"
#include "render/gl_status.h"
#include "render/legend.h"
#include "render/markers.h"
#include "render/mesh_pass.h"
#include "render/patch_pass.h"

namespace spool::render {

struct OverlayRenderer::Impl {
  BackgroundPass background;
  CloudPass cloud;
  DepthCloudPass depth_cloud;
  bool shows_depth = false;  // the depth image's points, else the cloud's
  bool depth_has_clutter = false;
  DepthShadePass depth_shade;
  MeshPass mesh;
  PatchPass patches;
  EdgePass edges;
  MeshPass ghost_mesh;
  EdgePass ghost_edges;
  bool has_ghost = false;
  CanvasPass canvas;
  std::vector<Marker> markers;

  void draw_points(const Offscreen& target, const View& view, const CloudStyle& style) const {
    if (shows_depth)
      depth_cloud.draw(target, view, style);
    else
      cloud.draw(target, view, style);
  }

  Status draw_legend(const Offscreen& target, const OverlayStyle& style) {
    const auto font = canvas.font(legend_text_px(style.scale));
    if (!font) return font.error();
    const LegendContent content{
        .range_m = style.colour_range_m,
        .neutral_m = style.neutral_m,
        .tolerance_m = style.tolerance_m,
        .units = style.units,
        .has_clutter =
            style.show_clutter && (shows_depth ? depth_has_clutter : cloud.has_clutter()),
        .has_contradicting = !shows_depth && cloud.has_contradicting()};
    const int free_height =
        target.height() - static_cast<int>(style.inset_top_px + style.inset_bottom_px);
    return canvas.draw(target, render::draw_legend(content, target.width(), free_height,
                                                   style.scale, **font, style.inset_top_px));
  }
};

namespace {

constexpr std::int32_t kGhostPart = 0;                   // all of it is one part …
constexpr std::array<int, 2> kGhostLit{kGhostPart, -1};  // … and lit
constexpr float kGhostLinePx = 2.5F;

// Makes a pass into its place; the first failure is kept in `status`.
template <class Pass>
void make(Pass& place, Status& status) {
  if (!status) return;
  auto made = Pass::create();
  if (made) {
    place = std::move(*made);
  } else {
    status = made.error();
  }
}

}  // namespace

Result<OverlayRenderer> OverlayRenderer::create() {
  auto impl = std::make_unique<Impl>();
  Status status;
  make(impl->background, status);
  make(impl->cloud, status);
  make(impl->depth_cloud, status);
  make(impl->depth_shade, status);
  make(impl->mesh, status);
  make(impl->patches, status);
  make(impl->edges, status);
  make(impl->ghost_mesh, status);
  make(impl->ghost_edges, status);
  make(impl->canvas, status);
  if (status) status = gl_status("preparing to draw");
  if (!status) return status.error();
  return OverlayRenderer(std::move(impl));
}

void OverlayRenderer::set_design(const TriangleMesh& mesh,
                                 std::span<const std::int32_t> triangle_part) {
  MeshGeometry geometry = prepare_mesh(mesh, triangle_part);
  impl_->mesh.set_mesh(geometry);
  impl_->edges.set_edges(std::move(geometry.creases), std::move(geometry.smooth));
}

void OverlayRenderer::set_ghost(const TriangleMesh& mesh) {
  const std::vector<std::int32_t> one(mesh.triangles.size(), kGhostPart);
  MeshGeometry geometry = prepare_mesh(mesh, one);
  impl_->has_ghost = !mesh.triangles.empty();
  impl_->ghost_mesh.set_mesh(geometry);
  impl_->ghost_edges.set_edges(std::move(geometry.creases), std::move(geometry.smooth));
}

void OverlayRenderer::set_points(std::span<const Eigen::Vector3f> points_design,
                                 std::span<const float> deviation_m,
                                 std::span<const std::uint8_t> classes) {
  impl_->cloud.set_points(points_design, deviation_m, classes);
  impl_->shows_depth = false;
}

Status OverlayRenderer::set_distances(const DistanceVolume& volume) {
  Status status = impl_->depth_cloud.set_distances(volume);
  if (!status) impl_->shows_depth = false;
  return status;
}

bool OverlayRenderer::has_distances() const { return impl_->depth_cloud.has_distances(); }

void OverlayRenderer::set_depth(const DepthPoints& points, bool has_clutter) {
  impl_->depth_cloud.set_depth(points);
  impl_->shows_depth = true;
  impl_->depth_has_clutter = has_clutter;
}

void OverlayRenderer::set_patches(std::span<const PatchMark> patches) {
  impl_->patches.set_patches(patches);
}

void OverlayRenderer::set_markers(std::span<const Marker> markers) {
  impl_->markers.assign(markers.begin(), markers.end());
}

Status OverlayRenderer::draw(const Offscreen& target, const View& view, const OverlayStyle& style) {
  assert(target.width() == view.camera.width && target.height() == view.camera.height &&
         "the view is of the target's size");
  const auto scale = static_cast<float>(style.scale);
  impl_->background.draw(target, style.show_background);
  if (style.show_cloud) {
    impl_->draw_points(target, view,
                       {.neutral_m = style.neutral_m,
                        .range_m = style.colour_range_m,
                        .size_px = style.point_size_px,
                        .spacing_m = style.point_spacing_m,
                        .show_clutter = style.show_clutter});
    if (style.shade_cloud) {
      impl_->depth_shade.draw(target, view, style.point_size_px, style.point_spacing_m);
    }
  }
  if (style.show_design) {
    impl_->mesh.draw(target, view, style.lit_parts, style.occlusion_tolerance_m);
    if (style.show_patches) impl_->patches.draw(target, view, style.occlusion_tolerance_m);
    impl_->edges.draw(target, view, style.lit_parts, 1.5F * scale,
                      0.5 * style.occlusion_tolerance_m);
  }
  if (style.show_ghost && impl_->has_ghost) {
    impl_->ghost_mesh.draw(target, view, kGhostLit, style.occlusion_tolerance_m);
    impl_->ghost_edges.draw(target, view, kGhostLit, kGhostLinePx * scale,
                            0.5 * style.occlusion_tolerance_m);
  }
  Status status = impl_->canvas.draw(target, draw_markers(impl_->markers, view, style.scale));
  if (status && style.show_legend && style.show_cloud) status = impl_->draw_legend(target, style);
  if (!status) return status;
  return gl_status("drawing the overlay");
}

OverlayRenderer::OverlayRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OverlayRenderer::OverlayRenderer(OverlayRenderer&&) noexcept = default;
OverlayRenderer& OverlayRenderer::operator=(OverlayRenderer&&) noexcept = default;
OverlayRenderer::~OverlayRenderer() = default;

}  // namespace spool::render
