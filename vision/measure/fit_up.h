// How two pipes meet at a butt weld: the step between their outsides (hi-lo).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/joint_error.h"
#include "vision/measure/part_feature.h"

namespace spool {

// Of every joint of two butt-weld ends, in the design's order: the offset of the two axes at the
// joint's place (across the mean axis) and the step of the radii; together the largest step of the
// outside around the joint. The step inside, which a weld procedure limits, is the same but for the
// wall's tolerance, and is not seen. Noise alone makes an offset positive: its share is taken off,
// |d|^2 = |d'|^2 - trace(C). Where one side has no cylinder of its own it is not measured, and a
// root gap never is.
[[nodiscard]] std::vector<FitUp> fit_ups(const DesignModel& design, const PartFeatures& features);

}  // namespace spool
