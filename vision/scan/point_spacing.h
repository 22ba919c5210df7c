// How far apart a scan's points are.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "vision/scan/point_index.h"

namespace spool {

// The median distance (m) of every `step`th of `points` (m) to its fourth neighbour among those of
// `index`, which hold the point itself; `most` (m) where that is further. `most` of no point.
[[nodiscard]] float point_spacing(const PointIndex& index, std::span<const Eigen::Vector3f> points,
                                  std::size_t step, float most);

}  // namespace spool
