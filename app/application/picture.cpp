// Draws one screen's pictures and the panels into one target.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "vision/inspect/facing.h"

namespace spool {

namespace {

std::vector<render::PatchMark> marks_of(const CoverageState& coverage) {
  using Sight = render::PatchMark::Sight;
  constexpr float kShare = 0.45F;  // of the distance between two: they do not touch
  std::vector<render::PatchMark> marks;
  if (!coverage.patches) return marks;
  const std::vector<SurfacePatch>& all = coverage.patches->all();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Sight sight = coverage.sight[k] == PatchSight::kKnown    ? Sight::kKnown
                        : coverage.sight[k] == PatchSight::kPartly ? Sight::kPartly
                                                                   : Sight::kNotSeen;
    marks.push_back({all[k].point, all[k].normal, kShare * all[k].radius_m, sight});
  }
  return marks;
}

}  // namespace

Result<Picture> Picture::create(const PreparedDesign& design, int width, int height, double dp) {
  Result<render::OverlayRenderer> overlay = render::OverlayRenderer::create();
  if (!overlay) return overlay.error();
  Result<render::OverlayRenderer> scan = render::OverlayRenderer::create();
  if (!scan) return scan.error();
  Result<render::ImguiPass> panels = render::ImguiPass::create();
  if (!panels) return panels.error();
  Picture picture(std::move(*overlay), std::move(*scan), std::move(*panels), dp);
  picture.overlay_.set_design(design.model.mesh, design.model.triangle_part);
  if (const Status status = picture.resize(width, height); !status) return status.error();
  return picture;
}

void Picture::show_parts(const DesignModel& design, const std::vector<bool>& is_shown,
                         const TriangleMesh* ghost) {
  TriangleMesh shown{.vertices = design.mesh.vertices, .triangles = {}};
  std::vector<std::int32_t> part;
  for (std::size_t t = 0; t < design.mesh.triangles.size(); ++t) {
    const std::int32_t of = design.triangle_part[t];
    if (of >= 0 && !is_shown[static_cast<std::size_t>(of)]) continue;
    shown.triangles.push_back(design.mesh.triangles[t]);
    part.push_back(of);
  }
  overlay_.set_design(shown, part);
  overlay_.set_ghost(ghost != nullptr ? *ghost : TriangleMesh{});
}

Status Picture::resize(int width, int height) {
  if (target_.width() == width && target_.height() == height) return {};
  Result<render::Offscreen> target = render::Offscreen::create(width, height);
  if (!target) return target.error();
  target_ = std::move(*target);
  parts_.clear();
  return {};
}

Status Picture::set_distances(const DistanceVolume& distances, const Camera& camera) {
  camera_ = camera;
  shown_revision_ = 0;  // the same state looks different now
  return overlay_.set_distances(distances);
}

// What contradicts the design is only known of the points that vision looked at.
bool Picture::colours_by_distances(const VisionState& state) const {
  return overlay_.has_distances() && state.is_tracked() && state.frame &&
         state.frame->width == camera_.width && state.frame->height == camera_.height &&
         std::find(state.classes.begin(), state.classes.end(), PointClass::kContradicting) ==
             state.classes.end();
}

int Picture::stride_px(const VisionState& state) const {
  return colours_by_distances(state) ? 1 : state.stride_px;
}

void Picture::set_state(const VisionState& state) {
  if (state.revision == shown_revision_) return;
  shown_revision_ = state.revision;
  std::vector<std::uint8_t> classes;
  if (colours_by_distances(state)) {
    const bool has_clutter = std::find(state.classes.begin(), state.classes.end(),
                                       PointClass::kClutter) != state.classes.end();
    overlay_.set_depth({.depth = state.frame->depth,
                        .camera = camera_,
                        .T_design_camera = state.T_design_camera,
                        .facing_beyond_m = kFacingSigmas * state.point_noise_m,
                        .facing_cosine = kFacingCosine},
                       has_clutter);
  } else {
    classes.reserve(state.classes.size());
    for (const PointClass c : state.classes) classes.push_back(static_cast<std::uint8_t>(c));
    overlay_.set_points(state.scan_design.points, state.deviations.distance_m, classes);
  }
  overlay_.set_patches(marks_of(state.coverage));
  // Before an alignment every point may be the object, and no deviation is known.
  const std::vector<float> unknown(state.scan.size(), std::numeric_limits<float>::quiet_NaN());
  classes.assign(state.scan.size(), static_cast<std::uint8_t>(PointClass::kObject));
  scan_.set_points(state.scan.points, unknown, classes);
}

// What no picture covers.
Status Picture::draw_background() {
  render::View view;
  view.camera = {.width = target_.width(), .height = target_.height(), .fx = 1, .fy = 1};
  render::OverlayStyle nothing;
  nothing.show_cloud = nothing.show_design = nothing.show_legend = false;
  scan_.set_markers({});
  return scan_.draw(target_, view, nothing);
}

render::OverlayStyle Picture::style_of(const ScenePicture& scene) const {
  render::OverlayStyle style;
  style.neutral_m = scene.neutral_m;
  style.show_cloud = scene.show_cloud;
  style.show_design = scene.show_design && !scene.of_scan;
  style.show_patches = scene.show_patches;
  style.show_legend = scene.show_legend;
  style.units = scene.units;
  style.lit_parts = scene.lit_parts;
  style.point_size_px = static_cast<float>(scene.point_px);
  style.scale = dp_;
  style.point_spacing_m = scene.point_spacing_m;
  style.inset_top_px = scene.legend_top_px;
  style.inset_bottom_px = std::max(0.0, target_.height() - scene.legend_bottom_px);
  return style;
}

Status Picture::keep_still(const VisionState& state, const ScenePicture& scene) {
  Result<render::Offscreen> made =
      render::Offscreen::create(scene.view.camera.width, scene.view.camera.height);
  if (!made) return made.error();
  set_state(state);
  overlay_.set_markers(scene.markers);
  if (const Status status = overlay_.draw(*made, scene.view, style_of(scene)); !status) {
    return status;
  }
  still_ = std::move(*made);
  still_rect_ = scene.rect;
  return {};
}

Status Picture::draw(const std::vector<ScenePicture>& scenes, const ImDrawData& panels) {
  const bool fills = scenes.size() == 1 && scenes.front().view.camera.width == target_.width() &&
                     scenes.front().view.camera.height == target_.height();
  if (!fills) {
    if (Status status = draw_background(); !status) return status;
  }
  std::size_t used = 0;
  for (const ScenePicture& scene : scenes) {
    render::OverlayRenderer& renderer = scene.of_scan ? scan_ : overlay_;
    renderer.set_markers(scene.markers);
    const render::OverlayStyle style = style_of(scene);
    const int width = scene.view.camera.width;
    const int height = scene.view.camera.height;
    if (width == target_.width() && height == target_.height()) {
      if (Status status = renderer.draw(target_, scene.view, style); !status) return status;
      continue;
    }
    if (parts_.size() <= used) parts_.emplace_back();
    render::Offscreen& part = parts_[used++];
    if (part.width() != width || part.height() != height) {
      Result<render::Offscreen> made = render::Offscreen::create(width, height);
      if (!made) return made.error();
      part = std::move(*made);
    }
    if (Status status = renderer.draw(part, scene.view, style); !status) return status;
    part.copy_to(target_, static_cast<int>(std::lround(scene.rect.x)),
                 static_cast<int>(std::lround(scene.rect.y)));
  }
  if (still_.width() > 0) {
    still_.copy_to(target_, static_cast<int>(still_rect_.x), static_cast<int>(still_rect_.y));
  }
  return panels_.draw(target_, panels);
}

}  // namespace spool
