// Depth counts to metres: the one place where a depth image becomes points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/core/point_cloud.h"
#include "vision/core/result.h"

namespace spool {

// The organised cloud of a frame in the camera frame (m): x = (u - cx) z / fx, y = (v - cy) z / fy,
// z = count * depth_unit_m with the calibration's warp taken off, NaN in all three where the count
// is 0. `pixels` is left empty (it would be the index). kBadInput where the frame's size is not the
// camera's or the intrinsics are not valid.
[[nodiscard]] Result<PointCloud> back_project(const DepthFrame& frame, const Camera& camera);

// Only the measured points, `pixels` saying which they were.
[[nodiscard]] PointCloud measured_points(const PointCloud& organised);

}  // namespace spool
