// The datum: where the features put its place, its axis and the turn about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "vision/measure/feature_geometry.h"

namespace spool {

struct DatumFrame {
  int node = -1;        // of the drawing, the datum's face; -1: there is none
  int clocked_by = -1;  // node that holds the turn about the datum's axis; -1: nothing does
  std::string text;     // for people: what it is, or why there is none
  // The measured frame of the datum by the features: z along the datum's leg, away from its face.
  std::function<Pose(const FeatureState&)> T_design_datum;
};

// See measure_dimensions().
[[nodiscard]] DatumFrame datum_frame(const DesignModel& design, const Drawing& drawing,
                                     const PartFeatures& features, const FeatureGeometry& geometry);

}  // namespace spool
