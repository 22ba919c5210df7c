// The datum frame that parts' poses are relative to: the datum's, its turn held also by a leg's
// way.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/measure/datum_frame.h"

namespace spool {

// datum_frame(). Where neither holes nor a point of the drawing hold the turn about its axis, the
// axis of the first pipe in the design's order that leaves that axis by more than 17 degrees does:
// while a spool is put together, its first leg beyond a bend is there before anything off the axis
// is. Empty where there is no datum.
struct PoseDatum {
  FrameFunction T_design_datum;
  bool is_turn_held = false;
  std::string text;  // for people: what it is, or why there is none
};
[[nodiscard]] PoseDatum pose_datum(const DesignModel& design, const Drawing& drawing,
                                   const PartFeatures& features, const FeatureGeometry& geometry);

}  // namespace spool
