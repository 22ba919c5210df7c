// Which scan points are of the design's surface: by distance, by normal, by what their neighbours
// are.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/find/dominant_planes.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"

namespace spool {

struct SurfaceClassOptions {
  double noise_m = 0.003;         // m; standard deviation of a point
  bool oriented_normals = false;  // the scan's normals point to the sensor
};

// Sets the class of every point that `deviations` holds a distance for: object where it lies on the
// surface within the noise and is not turned across it, or further off but in a patch of points
// that run along it (steel out of place by some millimetres is the object's, and its deviation
// is what is looked for); clutter else. Points on `planes` (floor, walls) are clutter.
// `classes`: one a point; points without a distance are clutter.
void classify_by_surface(const CloudView& scan_design, const Deviations& deviations,
                         std::span<const DominantPlane> planes, const SurfaceClassOptions& options,
                         std::span<PointClass> classes, const Watch& watch = {});

}  // namespace spool
