// Where each part stands against the drawing, by the features at it, the measured datum aligned.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/inspect/part_pose.h"
#include "vision/measure/drawing.h"
#include "vision/measure/part_feature.h"
#include "vision/measure/rules.h"

namespace spool {

// One a part of the design, in its order. Each is the mean of what its evidence says
// (pose_evidence()) and of the drawing, weighed by their whole covariances (generalised least
// squares; the drawing's own weight is that of kUnobservedSigma, so it decides only what nothing
// else does). Features' covariances reach the residuals through numerical derivatives, what several
// of them and the datum share in all of them; `scale_u` is the standard uncertainty of the sensor's
// scale, a fraction, and scales all lengths from the datum together.
//
// The datum is pose_datum()'s: without one no part has a pose. Where nothing holds the turn about
// its axis, every part may be turned about that by kUnobservedSigma besides, and says so.
// Of a cancelled run nothing is known. Pure; any thread.
[[nodiscard]] std::vector<PartPose> measure_part_poses(const DesignModel& design,
                                                       const Drawing& drawing,
                                                       const PartFeatures& features,
                                                       const RuleSet& rules, double scale_u,
                                                       const Watch& watch = {});

}  // namespace spool
