// Signed distance of every kept point to the design surface, and what it says of each part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/inspect/declutter.h"
#include "vision/scan/point_index.h"

namespace spool {

// One entry a scan point. Clutter: NaN and -1.
struct Deviations {
  std::vector<float> distance_m;  // + outside the design's surface
  std::vector<std::int32_t> part;
  std::vector<Eigen::Vector3f> normal;  // unit, outward, of the surface there
};

// What there is to say where there is no pose: no distance for any point.
[[nodiscard]] Deviations no_deviations(std::size_t scan_points);

// Points in the design frame; those further than `max_distance` (m) count as clutter: their class
// is changed. So do those that a cancelled run did not come to; there may be no entries at all
// then.
[[nodiscard]] Deviations measure_deviations(const CloudView& scan_design,
                                            std::span<PointClass> classes,
                                            const DesignSurface& surface, float max_distance,
                                            const Watch& watch = {});

// Point-to-surface statistics of one part. Scan quality and colour; never a verdict.
struct PartDeviation {
  std::size_t points = 0;
  double mean_m = 0, rms_m = 0, p95_abs_m = 0, max_abs_m = 0;
  double coverage = 0;  // share of the part's surface samples with an object point near
};

// One a part, in the design's order. Of a cancelled run they mean nothing.
[[nodiscard]] std::vector<PartDeviation> summarise_parts(
    const DesignModel& design, const CloudView& scan_design, std::span<const PointClass> classes,
    const Deviations& deviations, const SurfaceSamples& samples, const Watch& watch = {});

// The distance (m) within which an object point vouches for a surface sample: as far apart as
// samples are (`sample_radius`), or as the scan's own points are where it is the sparser (median
// distance to the fourth neighbour). `index`: over `points`.
[[nodiscard]] double vouching_radius(const PointIndex& index,
                                     const std::vector<Eigen::Vector3f>& points,
                                     double sample_radius);

// Root mean square of the object's finite distances (eq. 3.1), m. Scan quality only: steel that
// contradicts the design says nothing of it. `classes`: one a deviation.
[[nodiscard]] double rms(const Deviations& deviations, std::span<const PointClass> classes);

}  // namespace spool
