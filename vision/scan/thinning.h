// Fewer points of the same surface: a voxel grid keeps the mean of each cell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/point_cloud.h"

namespace spool {

// One point a cell of edge `cell_m`: the mean of its points, their mean normal renormalised,
// `pixels` the place in the input of the point nearest to the mean. Points that are not finite are
// dropped. Same input, same output, in a fixed order. cell_m > 0. Nothing where it was cancelled.
[[nodiscard]] PointCloud thin_to_voxels(const CloudView& cloud, double cell_m,
                                        const Watch& watch = {});

// The cell edge that leaves about `target` points (never more than 5 % over), or 0 where there are
// fewer already.
[[nodiscard]] double voxel_size_for(const CloudView& cloud, std::size_t target);

}  // namespace spool
