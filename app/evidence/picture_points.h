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

// The box of all that a picture is of (m, design frame): the design's, and what of the steel
// contradicts it.
[[nodiscard]] Eigen::AlignedBox3d steel_bounds(const PicturePoints& points,
                                               const Eigen::AlignedBox3d& design);

// Without the clutter that would hide steel seen from `eye` (m, design frame): a table seen from
// below, a person between. Steel is the design's surface no further than `reach_m`, and what
// contradicts it, which stays, whatever it hides. `spacing_m`: object_spacing().
[[nodiscard]] PicturePoints without_hiding_clutter(const PicturePoints& all,
                                                   const DesignSurface& surface,
                                                   const Eigen::Vector3d& eye, float reach_m,
                                                   double spacing_m);

// How far the object's points lie apart (m): from the distance d to the fourth neighbour, as four
// points stand for a disc of radius d; the median over some hundreds. 0 where there are too few to
// tell.
[[nodiscard]] double object_spacing(const PicturePoints& points);

}  // namespace spool::evidence
