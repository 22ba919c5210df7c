// What of a scan is the design, what contradicts it, and what is neither.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/point_cloud.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/find/dominant_planes.h"
#include "vision/inspect/chain_pieces.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"
#include "vision/inspect/unexpected.h"

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
  std::vector<Unexpected> unexpected;  // joined to the spool, and not the design's
  std::vector<DominantPlane> planes;   // floor, walls, tables; m, design frame
};

// The scan as it is compared.
struct ExplainedScan {
  const PointCloud& design;      // every point, m, design frame, NaN allowed
  double noise_m = 0.003;        // of a point
  bool oriented_normals = true;  // its normals, if any, point to the sensor
};

// How far (m) from the surface a point still counts as the object's. Ten standard deviations: no
// reading of the surface gets there by noise. At least 20 mm, over three times the widest tolerance
// of PFI ES-3 for a dimension (6 mm), so that an error worth a verdict is coloured and not cut
// away.
[[nodiscard]] float deviation_bound(double noise_m);

// What lies on the design's surface, and what is floor and wall: no pieces yet. Of a cancelled run
// it says nothing.
[[nodiscard]] Explanation explain_surface(const ExplainedDesign& design, const ExplainedScan& scan,
                                          const Watch& watch = {});

// By the thesis: the K nearest scan points of every model point are the object, nothing
// contradicts.
[[nodiscard]] Explanation explain_by_thesis(const ExplainedDesign& design,
                                            const ExplainedScan& scan,
                                            const DeclutterOptions& options,
                                            const Watch& watch = {});

// Adds to explain_surface() pieces that are elsewhere, seen from the datum, and steel that is not
// the design's: their points contradict it.
void explain_pieces(const ExplainedDesign& design, const ExplainedScan& scan, const Watch& watch,
                    Explanation& explanation);

// The best explained pieces among `tree` that are elsewhere. Their points are given as places in
// the scan.
[[nodiscard]] std::vector<Piece> moved_pieces(const ExplainedDesign& design,
                                              const ExplainedScan& scan,
                                              const Explanation& explanation,
                                              std::span<const JointBranch> tree,
                                              std::size_t most_pieces, const Watch& watch = {});

}  // namespace spool
