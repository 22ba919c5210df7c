// Whether the scan shows a part from end to end, or leaves out a length of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/design/sampling.h"

namespace spool {

// `own_points`: m, design frame; of each part, the scan's points on it. A part has a gap where
// nothing of it shows all round: what only looks away from the scanner, lies on the floor or behind
// something narrower than the part has points of the part across from it. 1 for a part with a gap,
// 0 for one without or without any surface to be seen. Nearer than `near_m` to a point of its own
// the surface shows. Of a cancelled run it means nothing.
[[nodiscard]] std::vector<std::uint8_t> parts_with_gaps(
    const SurfaceSamples& samples, const std::vector<std::vector<Eigen::Vector3f>>& own_points,
    float near_m, const Watch& watch = {});

}  // namespace spool
