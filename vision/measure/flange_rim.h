// A flange's outside diameter by the points on its rim.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/measure/part_feature.h"

namespace spool {

struct FlangeRim {
  double nominal_m = 0;  // diameter as drawn
  double diameter_m = 0, u_m = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, design frame
};

// Of a flange or blind with a face: the circle, its radius free, through the readings whose foot on
// the design lies on the rim, a sixth of its thickness away from either edge (there readings are
// lost or drawn aside), seen along the face's measured normal or where there is none the drawn one.
// Robust (Tukey); the uncertainty is the fit's with correlated readings counted as one, grown by
// Birge's ratio of patches round the rim, and `patch_error_m` of all features besides. Nothing
// where too few points lie there or the arc does not hold a circle.
[[nodiscard]] std::optional<FlangeRim> measure_rim(const DesignModel& design,
                                                   const FeatureScan& scan,
                                                   const PartFeatures& features, int part,
                                                   const Watch& watch = {});

}  // namespace spool
