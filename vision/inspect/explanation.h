// What of a scan is the design, what contradicts it, and what is neither.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/point_cloud.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/inspect/chain_pieces.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"

namespace spool {

// The design that a scan is compared with; all outlive the call.
struct ExplainedDesign {
  const DesignModel& model;
  const DesignSurface& surface;
  const SurfaceSamples& samples;
};

struct Explanation {
  DeclutterResult declutter;  // the class of each scan point
  Deviations deviations;      // of object and contradicting points
  std::vector<Piece> pieces;  // of the spool that are there, elsewhere than the design has them
};

// `scan_design`: every scan point, m, design frame, NaN allowed. `noise_m`: of a point.
// `oriented_normals`: its normals, if any, point to the sensor. Thesis methods: the K nearest scan
// points of every model point are the object, nothing contradicts. Of a cancelled run it says
// nothing.
[[nodiscard]] Explanation explain_scan(const ExplainedDesign& design, const PointCloud& scan_design,
                                       double noise_m, bool oriented_normals,
                                       const DeclutterOptions& options, const Watch& watch = {});

}  // namespace spool
