// Which points of an inspection a picture shows, and how far they lie apart.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "vision/design/design_surface.h"
#include "vision/inspect/inspection.h"

namespace spool::evidence {

// What the renderer takes of one state; arrays of one length.
struct PicturePoints {
  std::vector<Eigen::Vector3f> positions;  // m, design frame
  std::vector<float> deviation_m;
  std::vector<std::uint8_t> classes;
};

// The object's and contradicting points all, clutter only near the design's `bounds`: a far wall
// tells nothing of the steel. Points that are not finite are left out; nothing where no point was
// classified.
[[nodiscard]] PicturePoints points_near_design(const Inspection& inspection,
                                               const Eigen::AlignedBox3d& bounds);

// Without the clutter that would hide steel seen from `eye` (m, design frame): a table seen from
// below, a person between. What contradicts the design stays, whatever it hides. Steel further than
// `reach_m` does not count.
[[nodiscard]] PicturePoints without_hiding_clutter(const PicturePoints& all,
                                                   const DesignSurface& surface,
                                                   const Eigen::Vector3d& eye, float reach_m);

// How far the object's points lie apart (m): from the distance d to the fourth neighbour, as four
// points stand for a disc of radius d; the median over some hundreds. 0 where there are too few to
// tell.
[[nodiscard]] double object_spacing(const PicturePoints& points);

}  // namespace spool::evidence
