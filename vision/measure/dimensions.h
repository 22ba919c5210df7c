// The drawing's dimensions by its joint graph, measured from the features and judged by the rules.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/dimension.h"
#include "vision/measure/drawing.h"
#include "vision/measure/part_feature.h"
#include "vision/measure/rules.h"

namespace spool {

struct DimensionOptions {
  double scale_u = 0.005;       // standard uncertainty of the sensor's scale, a fraction
  double scale_correction = 0;  // lengths are divided by one and this
  std::string nothing_ok;       // why nothing may be ok whatever is measured; empty: it may
};

struct MeasuredDrawing {
  std::vector<Dimension> dimensions;
  std::string datum;  // what offsets are relative to, or why there is no such thing
};

// Of every leg its length (face_to_face, centre_to_face, …) along its measured centreline; at every
// elbow and tee the angle between legs; of every flange how far its face leans against the pipe
// that it is on (face_alignment); of every face but the datum's how far it stands aside of where
// the drawing has it, seen from the datum (offset), across its own leg in two directions; all that
// lies between is part of it. Of every flange with holes how it is turned about its axis
// (rotation_of_holes()); of every part with marks the same, listed and not measured.
//
// The datum is the first of the design's `datums` that is a flange, else the flange that is known
// best: its centre, the axis of its leg, and about that axis its own bolt holes, or where these are
// not known or half a pitch off the point of the drawing that lies furthest off it.
//
// Nominal is measured in the same way on the design's own features. A dimension of which a feature
// is missing, or that would move with what no feature holds, is not_measured with the reason.
[[nodiscard]] MeasuredDrawing measure_dimensions(const DesignModel& design, const Drawing& drawing,
                                                 const PartFeatures& features, const RuleSet& rules,
                                                 const DimensionOptions& options = {});

}  // namespace spool
