// Parts of which nothing shows although what they are joined to does.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/design/sampling.h"
#include "vision/inspect/deviation.h"

namespace spool {

// The parts, ascending. A part's own surface is looked for where nothing else of the design is near
// enough to be taken for it: the end of a pipe lies on the hub of the flange that is not there.
// `scan_design`: m, design frame, of which the object's points count; `parts`: summarise_parts() of
// the same. None of a cancelled run.
[[nodiscard]] std::vector<int> missing_parts(const DesignModel& design,
                                             const CloudView& scan_design,
                                             std::span<const PointClass> classes,
                                             const SurfaceSamples& samples,
                                             const std::vector<PartDeviation>& parts,
                                             const Watch& watch = {});

}  // namespace spool
