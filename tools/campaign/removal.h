// Takes whole pieces of the object out of a scan, as if they had not been seen (thesis 4.4.2.3).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/random.h"
#include "tools/campaign/scene.h"
#include "tools/campaign/sensed.h"

namespace spool::campaign {

// Leaves the share `completeness` of each object's points and gives the share that came out. What
// goes hangs together: from the end of a branch inwards along the pipes, or from one side of the
// object; of a frame always a side.
double remove_pieces(const Scene& scene, double completeness, Random random,
                     std::vector<SensedPoint>& points);

}  // namespace spool::campaign
