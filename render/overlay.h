// The picture: live cloud coloured by deviation, clear design, legend. One state in, pixels out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/depth_cloud_pass.h"
#include "render/offscreen.h"
#include "render/view.h"
#include "vision/core/result.h"
#include "vision/core/triangle_mesh.h"

namespace spool::render {

enum class LengthDisplay { kMillimetre, kFeetInch };

// A cross or ring on the picture: a proposed or picked point.
struct Marker {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // m, design frame
  enum class Kind { kProposed, kPicked, kScan } kind = Kind::kProposed;
  std::string label;  // "1"
};

// How well a patch of the design is known: a full disc, a ring, a dashed ring on its surface.
struct PatchMark {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // m, design frame
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();   // unit, outward
  float radius_m = 0;
  enum class Sight { kNotSeen, kPartly, kKnown } sight = Sight::kNotSeen;
};

struct OverlayStyle {
  double colour_range_m = 0.010;  // m; the ends of the deviation colours
  double neutral_m = 0.001;       // m; half width of the grey band
  double tolerance_m = 0.003;     // m; marked on the legend
  float point_size_px = 3.0F;
  double point_spacing_m = 0;  // m; where set, near points grow so that a surface has no holes
  double occlusion_tolerance_m = 0.010;  // m; points so little behind the design still hide it
  bool shade_cloud = true;               // darken by depth, so that form can be read
  bool show_background = true;
  bool show_cloud = true;
  bool show_clutter = true;  // points that are not the object: dim
  bool show_design = true;
  bool show_ghost = true;     // where there is one
  bool show_patches = false;  // on the design, where it is shown
  bool show_legend = true;
  double inset_top_px = 0;     // covered by a strip of the screen: the legend stays clear of it
  double inset_bottom_px = 0;  // and of what covers the bottom
  LengthDisplay units = LengthDisplay::kMillimetre;
  std::array<int, 2> lit_parts{-1, -1};  // drawn brighter; -1: none
  double scale = 1.0;                    // of text and marks: pixels a density-independent unit
};

// Owns the GL side of one overlay. GL thread only; made while a context is current.
class OverlayRenderer {
 public:
  [[nodiscard]] static Result<OverlayRenderer> create();
  OverlayRenderer(OverlayRenderer&&) noexcept;
  OverlayRenderer& operator=(OverlayRenderer&&) noexcept;
  ~OverlayRenderer();

  // The design's triangles (m, design frame) and the part of each. A design that is a bare cloud:
  // no triangles.
  void set_design(const TriangleMesh& mesh, std::span<const std::int32_t> triangle_part);
  // The next part where it belongs: its triangles (m, design frame), in a colour of its own, its
  // edges showing through what stands before it. Drawn where the style has show_ghost. No
  // triangles: none.
  void set_ghost(const TriangleMesh& mesh);
  // The points of one state in the design frame (m), their signed deviation (m; NaN: clutter or
  // unknown) and class (0 clutter, 1 object, 2 contradicting). All of one length; not finite points
  // are not drawn.
  void set_points(std::span<const Eigen::Vector3f> points_design,
                  std::span<const float> deviation_m, std::span<const std::uint8_t> classes);
  void set_patches(std::span<const PatchMark> patches);
  // The design's distances (frame and units as above), with which points can be coloured here;
  // uploaded once, not needed afterwards. kNoDevice where the driver has no room for them.
  [[nodiscard]] Status set_distances(const DistanceVolume& volume);
  [[nodiscard]] bool has_distances() const;
  // The points are a depth image's from now on, until set_points(): each pixel is placed and
  // coloured by the graphics card. After set_distances(). `has_clutter`: as the legend is to say.
  void set_depth(const DepthPoints& points, bool has_clutter);
  void set_markers(std::span<const Marker> markers);
  // Draws into the target; occlusion of the design by the points is by their depth.
  [[nodiscard]] Status draw(const Offscreen& target, const View& view, const OverlayStyle& style);

 private:
  struct Impl;
  explicit OverlayRenderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool::render
