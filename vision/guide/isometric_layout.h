// Where an isometric draws each node: lengths not to scale, axes at 30 degrees, the side that hides
// least.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "vision/guide/centre_line.h"
#include "vision/guide/drawing.h"

namespace spool::guide {

// Paper (mm, y down) from east, north, up for one of the four sides that an isometric is drawn
// from: with north to the upper right (0), upper left (1), lower left (2), lower right (3).
[[nodiscard]] Eigen::Matrix<double, 2, 3> isometric_axes(int quarter);

// From the spool towards who looks, unit, in east, north, up: what is further along hides.
[[nodiscard]] Eigen::Vector3d towards_eye(int quarter);

struct IsometricLayout {
  int quarter = 0;
  double scale = 1;                     // of symbols, as the whole was fitted into its area
  std::vector<Eigen::Vector3d> drawn;   // by node: east, north, up as drawn, mm
  std::vector<Eigen::Vector2d> places;  // by node: mm on paper, y down
};

// Lengths are compressed axis by axis with the order of all coordinates kept, so what lies east of
// something is drawn east of it, what is level stays level, and a ring of legs closes; each leg is
// at least as long as its symbols need. A branch on a skew leg may draw that leg with a bend. Of
// the four sides the one with the fewest legs that cross or lie on one another, north upwards where
// that is equal. Fits the whole into `area`. Pure; any thread.
[[nodiscard]] IsometricLayout lay_out(const DesignModel& design, const CentreLine& line,
                                      const Box2& area);

}  // namespace spool::guide
