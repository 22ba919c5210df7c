// How far a point is from a part, by solids added and cut away: formulas that the generator's
// patches do not use.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/assembly.h"

namespace spool::campaign::test {

// Signed (m, + outside), zero exactly on the surface; next to corners nearer to zero than the true
// distance, never further (Quilez, "distance functions": unions and cuts give bounds).
[[nodiscard]] double solid_distance(const PartSpec& spec, const Eigen::Vector3d& point);

}  // namespace spool::campaign::test
