// What a closed loop moves the design by: the piece of the scan map that its datum lies in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/scan/scan_map.h"

namespace spool {

// Where numbers are measured from: the box of the design's first datum (m, design frame), of a
// design without datums or triangles that of all of it.
[[nodiscard]] Eigen::AlignedBox3d datum_box(const DesignModel& design);

// The motion, in the map frame, of the cells that lay in `box` (m, design frame) before the map's
// pieces moved by `motions` (by MapCell::keyframe): the mean over the cells, told at the box's
// middle. `map`: after it moved. Where no cell lay there: `otherwise`.
[[nodiscard]] Pose motion_of_piece(const ScanMap& map, std::span<const Pose> motions,
                                   const Pose& T_design_map_before, const Eigen::AlignedBox3d& box,
                                   const Pose& otherwise);

}  // namespace spool
