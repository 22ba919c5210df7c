// From many points to as many as asked for, at one spacing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "tools/campaign/random.h"
#include "tools/campaign/sensed.h"

namespace spool::campaign {

// Thins the object to its target by Poisson disks, the clutter to the same spacing and then to what
// lies nearest to `object`; where that is too little, more closely. Fewer than asked for where
// there are fewer.
[[nodiscard]] std::vector<SensedPoint> thinned_to(const std::vector<SensedPoint>& points,
                                                  const PointTargets& targets,
                                                  const Eigen::AlignedBox3d& object, Random random);

}  // namespace spool::campaign
