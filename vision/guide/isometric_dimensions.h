// The dimensions of an isometric: between the places of each leg that a fitter measures between.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/guide/centre_line.h"
#include "vision/guide/isometric_layout.h"
#include "vision/guide/label_placement.h"

namespace spool::guide {

// A length of a leg along its direction, m: as the file has it, whatever the drawing shows.
struct LegLength {
  int run = -1;
  int from = -1, to = -1;  // nodes
  double length_m = 0;
};

// Each leg cut at centres of tees and crosses, feet of branches, faces, ends of reducers, and welds
// of site and yard; of caps the weld counts, and gaskets are left out. Pure; any thread.
[[nodiscard]] std::vector<LegLength> leg_lengths(const DesignModel& design, const CentreLine& line);

// A skew leg's travel along east, north and up (m) between its ends, signed; shown as a triangle or
// box with the offsets that are not zero.
struct SkewOffset {
  int run = -1;
  int axis = 0;         // 0 east, 1 north, 2 up
  double travel_m = 0;  // signed
  Segment2 line;        // mm on paper
};

struct DrawnDimension {
  LegLength length;
  Segment2 line;  // mm, with its arrows
  Segment2 witness_a, witness_b;
};

// Dimension lines beside their legs, on the side where least is in the way of `lines` (their own
// are added to it). Paper mm. Pure; any thread.
[[nodiscard]] std::vector<DrawnDimension> draw_dimensions(const CentreLine& line,
                                                          const IsometricLayout& layout,
                                                          const std::vector<LegLength>& lengths,
                                                          const Box2& area,
                                                          std::vector<LineToAvoid>& lines);

// The triangles and boxes of skew legs of at least `kLeastSkew_m`, with their hatching in `hatch`.
inline constexpr double kLeastSkew_m = 0.05;
[[nodiscard]] std::vector<SkewOffset> skew_offsets(const CentreLine& line,
                                                   const IsometricLayout& layout,
                                                   std::vector<Stroke>& hatch);

}  // namespace spool::guide
