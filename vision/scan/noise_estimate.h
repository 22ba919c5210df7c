// The random error of a cloud's points, found in the cloud itself.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cloud_view.h"

namespace spool {

// Standard deviation (m) of the points across their surface: the median over some two thousand
// places of the residual about a quadric height field through the nearest neighbours, so that
// neither curvature nor edges nor clutter count as noise. At least 0.1 mm: paint and mill scale are
// not smoother, and a sampled CAD surface would else claim perfection. 0.1 mm too
// where there are too few points to tell.
[[nodiscard]] double estimate_noise(const CloudView& cloud);

}  // namespace spool
