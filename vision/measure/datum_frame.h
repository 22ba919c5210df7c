// The datum: where the features put its place, its axis and the turn about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/measure/feature_geometry.h"

namespace spool {

struct DatumFrame {
  int node = -1;  // of the drawing, the datum's face; -1: there is none
  // What holds the turn about the datum's axis: the feature of its own bolt holes or, where that
  // is not known, the node furthest off it; -1: not that.
  int holes = -1;
  int clocked_by = -1;
  std::string text;  // for people: what it is, or why there is none
  // The measured frame of the datum by the features: z along the datum's leg, away from its face.
  FrameFunction T_design_datum;
  // The same, turned by the node `clocked_by`, whatever the holes say: what the datum's own holes
  // are compared with. Empty where there is no such node.
  FrameFunction T_design_by_node;

  [[nodiscard]] bool is_clocked() const { return holes >= 0 || clocked_by >= 0; }
};

// A flange whose holes stand so near to half their pitch from where they should (as a share of the
// pitch) was one-holed: the wrong hole of two was set on the centreline.
inline constexpr double kOneHoledWithin = 0.125;
// `turn_rad`: off by so much; `count`: holes.
[[nodiscard]] bool is_one_holed(double turn_rad, int count);

// See measure_dimensions().
[[nodiscard]] DatumFrame datum_frame(const DesignModel& design, const Drawing& drawing,
                                     const PartFeatures& features, const FeatureGeometry& geometry);

}  // namespace spool
