// Density normalisation: one mean point a leaf of an octree (thesis 4.3.1).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/point_cloud.h"
#include "vision/scan/octree.h"

namespace spool {

// One point a leaf that holds points: their mean, their mean normal renormalised, `pixels` the
// place in the input of the point nearest to the mean. Points (m) that are not finite are dropped.
// Same input, same output, sorted by leaf. A capacity alone keeps the density's differences;
// max_size_m evens them out. Cancelled: what the leaves are by then.
[[nodiscard]] PointCloud thin_by_octree(const CloudView& cloud, const OctreeOptions& options,
                                        const Watch& watch = {});

// Leaves whose points fill no more than a box of `leaf_m` (m, over 0), and no other bound: the
// options of an even density.
[[nodiscard]] OctreeOptions even_leaves(double leaf_m, OctreeSplit split = OctreeSplit::kWeighted);

}  // namespace spool
