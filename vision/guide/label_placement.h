// Where labels go so that none lies on another, and few on a line.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/guide/drawing.h"
#include "vision/guide/plane_geometry.h"

namespace spool::guide {

// A line that labels keep off, and what a millimetre of it under a label costs.
struct LineToAvoid {
  Segment2 line;
  double cost = 1;
};

struct LabelRequest {
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();     // mm: what it names
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();  // mm
  bool may_cover_anchor = false;                    // as the number of a dimension does its line
  Eigen::Vector2d slide = Eigen::Vector2d::Zero();  // mm: it may as well sit this far to each side
};

struct PlacedLabel {
  Box2 box;
  bool is_placed = false;  // false: the area is full; it has no place
  bool needs_leader = false;
  Segment2 leader;  // from the anchor to the box
};

// One label each request, in their order (the first are placed first), within `area`, on no other
// label, none of `boxes` and no leader. Of all places on rings about the anchor the cheapest: near,
// off the lines, its leader across nothing; where no ring has one, the nearest free place of the
// area. Deterministic. Millimetres. Pure; any thread.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                                    const std::vector<LineToAvoid>& lines,
                                                    const std::vector<Box2>& boxes,
                                                    const Box2& area);

}  // namespace spool::guide
