// Floor and walls that end the scan: what lies behind them nobody can have seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/find/dominant_planes.h"

namespace spool {

// Those of `planes` behind which next to nothing of the scan lies (points in m, finite; readings
// within `band_m` of a plane are the plane's own), turned so that the scan lies where the normal
// points. A table with its legs and the floor below is none.
[[nodiscard]] std::vector<DominantPlane> outer_planes(std::span<const Eigen::Vector3f> points,
                                                      std::span<const DominantPlane> planes,
                                                      double band_m);

// More than `band_m` (m) behind one of `outer`, where the scan showed that plane: past its edge
// something may hang down.
[[nodiscard]] bool is_behind(std::span<const DominantPlane> outer, const Eigen::Vector3f& place,
                             double band_m);

}  // namespace spool
