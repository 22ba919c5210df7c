// The scan map as it should look from a place: one facet a pixel, for matching by projection.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/core/camera.h"
#include "vision/core/pose.h"
#include "vision/scan/scan_map.h"

namespace spool {

// A cell as it looks from the view's camera.
struct MapFacet {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m, view camera frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit
  float variance = 0;                                // m^2, of the cell's mean along the normal
  float size = 0;                                    // m, its voxel; 0: no facet at this pixel
  KeyframeId keyframe = 0;                           // that the cell moves with
};

// The settled cells that look at the camera, the nearest of each pixel; of those as near within
// three percent the best known one, so that noise does not choose. Cells are a little wider than
// pixels or a little narrower: neighbours of a pixel have to be looked at too. Immutable.
class MapView {
 public:
  // `camera` may be smaller than the sensor's and look farther aside (with_margin()).
  // `of`: by keyframe, whether its cells are looked at (those past its end are not); empty: all.
  MapView(const ScanMap& map, const Camera& camera, const Pose& T_map_view,
          const std::vector<bool>& of = {});

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Pose& T_map_view() const { return T_map_view_; }
  [[nodiscard]] std::size_t facet_count() const { return facet_count_; }
  [[nodiscard]] const MapFacet& at(int u, int v) const {
    return facets_[static_cast<std::size_t>(v * camera_.width + u)];
  }

 private:
  Camera camera_;
  Pose T_map_view_;
  std::size_t facet_count_ = 0;
  std::vector<MapFacet> facets_;
};

// The same lens with `width` pixels across the old picture, and an eighth of that more on every
// side.
[[nodiscard]] Camera with_margin(const Camera& camera, int width);

}  // namespace spool
