// ICP from point to point, as the thesis refines its match with; else see vision/align/icp.h.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/scan/point_index.h"

namespace spool {

struct PointIcpOptions {
  int iterations = 5;     // thesis Table 4-2
  double reach_m = 0.05;  // m; model points with no scan point within it have no correspondence
};

// T_design_scan improved by so many rounds of Besl & McKay 1992: each model point (m, design frame)
// goes with its nearest scan point (m, scan frame; `scan_index` over `scan`), then least squares.
// Ends early where fewer than three model points have a neighbour, or nothing moves any more.
[[nodiscard]] Pose refine_point_to_point(const CloudView& model, const PointIndex& scan_index,
                                         const CloudView& scan, const Pose& T_design_scan,
                                         const PointIcpOptions& options = {});

}  // namespace spool
