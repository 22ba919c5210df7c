// Draws one screen's pictures and the panels into one target: the same for a window and for a file.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/layout.h"
#include "render/imgui_pass.h"
#include "render/offscreen.h"
#include "render/overlay.h"
#include "render/view.h"
#include "vision/inspector.h"
#include "vision/live/vision_state.h"

struct ImDrawData;

namespace spool {

// One picture of the scene within the screen.
struct ScenePicture {
  ui::Rect rect;      // where it stands, px
  render::View view;  // its camera is rect's size
  bool of_scan =
      false;  // the bare scan in the camera frame; else design and overlay in the design frame
  bool show_cloud = true;
  bool show_design = true;
  bool show_patches = false;  // how well the design is known, on it
  bool show_legend = false;
  render::LengthDisplay units = render::LengthDisplay::kMillimetre;  // of the legend
  double legend_top_px = 0, legend_bottom_px = 0;  // between these the legend stands
  double point_px = 3;         // so large that the cloud closes to a surface as the camera sees it
  double point_spacing_m = 0;  // and from nearer
  std::array<int, 2> lit_parts{-1, -1};
  double neutral_m = 0.001;             // half width of the grey band
  std::vector<render::Marker> markers;  // in the picture's world
};

// GL thread only; made while a context is current and gone before it.
class Picture {
 public:
  [[nodiscard]] static Result<Picture> create(const PreparedDesign& design, int width, int height,
                                              double dp);

  [[nodiscard]] Status resize(int width, int height);
  // From now on the points of tracked states are the pixels of their frames, each placed and
  // coloured by the graphics card. kNoDevice where the driver has no room for that: all stays as it
  // was.
  [[nodiscard]] Status set_distances(const DistanceVolume& distances, const Camera& camera);
  // Which parts of the design are drawn, one a part (all at first), and the next part where it
  // belongs (m, design frame; nullptr: none).
  void show_parts(const DesignModel& design, const std::vector<bool>& is_shown,
                  const TriangleMesh* ghost);
  // Every so many pixels of a state's frame are drawn as points.
  [[nodiscard]] int stride_px(const VisionState& state) const;
  // What the scene's pictures show from now on; nothing is sent to the GPU for a state already
  // there.
  void set_state(const VisionState& state);
  [[nodiscard]] Status draw(const std::vector<ScenePicture>& scenes, const ImDrawData& panels);
  // Draws a state once into a small picture of its own, which stands in draw() at `scene.rect`
  // until drop_still().
  [[nodiscard]] Status keep_still(const VisionState& state, const ScenePicture& scene);
  void drop_still() { still_ = {}; }
  [[nodiscard]] const render::Offscreen& target() const { return target_; }

 private:
  Picture(render::OverlayRenderer overlay, render::OverlayRenderer scan, render::ImguiPass panels,
          double dp)
      : overlay_(std::move(overlay)), scan_(std::move(scan)), panels_(std::move(panels)), dp_(dp) {}

  [[nodiscard]] bool colours_by_distances(const VisionState& state) const;
  [[nodiscard]] Status draw_background();
  [[nodiscard]] render::OverlayStyle style_of(const ScenePicture& scene) const;

  render::OverlayRenderer overlay_;  // design and measured points, design frame
  render::OverlayRenderer scan_;     // points only, camera frame
  render::ImguiPass panels_;
  render::Offscreen target_;
  std::vector<render::Offscreen> parts_;  // pictures that do not fill the screen
  render::Offscreen still_;               // empty: there is none
  ui::Rect still_rect_;
  std::uint64_t shown_revision_ = 0;
  double dp_ = 1;
  Camera camera_;  // of the frames that are coloured by distances
};

}  // namespace spool
