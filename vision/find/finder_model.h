// What is prepared of a design so that it can be found in a scan within a fraction of a second.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/find/elements.h"
#include "vision/find/pair_table.h"
#include "vision/find/straight_runs.h"
#include "vision/find/surface_field.h"
#include "vision/find/symmetry.h"

namespace spool {

// The scale at which a neighbourhood is looked at: the scan is thinned to `cell_m` first.
struct FinderLevel {
  ElementOptions elements;
  double cell_m = 0;  // m
  PairTable pairs;
};

// Immutable once prepared; shared by threads. All lengths follow from the design's own size.
struct FinderModel {
  double size_m = 0;                    // m, the design's diagonal
  PointCloud samples;                   // of the surface that can be seen, with normals
  std::vector<std::int32_t> part;       // of each sample
  std::vector<Eigen::Vector3f> probes;  // some of the samples in random order: a full score
  SurfaceField field;                   // over `samples`
  double spacing_m = 0;                 // m; between samples: none are nearer to each other
  std::vector<FinderLevel> levels;      // in the order in which they are tried
  std::size_t parts = 0;                // of the design
  StraightRuns runs;                    // parts in one line
  std::vector<std::uint8_t> is_stop;    // of each sample: a pipe through there would not have it
  std::vector<SelfLikeness> alike;      // motions that lay half of the design or more on itself
  std::vector<Pose> symmetries;         // of those, the ones that change nothing at all
  int free_motions = 0;                 // of the whole design: one of a body of revolution

  // Distances that the search counts in, m.
  [[nodiscard]] double rough_m() const { return 0.015 * size_m; }  // a pair's pose is off by this
  [[nodiscard]] double cell_m() const { return size_m / 150; }     // of the thinned scan
  // A point on the surface has a sample within this, to within a cell of the field.
  [[nodiscard]] double beside_m() const { return std::max(field.cell_m(), spacing_m); }
  // Poses that move the design by less than this (mean) are one.
  [[nodiscard]] double same_m() const { return 0.02 * size_m; }

  // `samples` of the surface that can be seen (PreparedDesign has them), under 65 535. Takes about
  // a second; a cancelled one is of no use: nothing may be looked for with it.
  [[nodiscard]] static FinderModel prepare(const DesignModel& design, const DesignSurface& surface,
                                           const SurfaceSamples& samples, std::uint32_t seed = 1,
                                           const Watch& watch = {});

  // Whether the two poses differ by a symmetry of the design.
  [[nodiscard]] bool are_symmetric(const Pose& T_a, const Pose& T_b) const;
};

// How far (m) the second pose puts the design from where the first has it: mean over some samples.
[[nodiscard]] double displacement_m(const FinderModel& model, const Eigen::Isometry3f& T_a,
                                    const Eigen::Isometry3f& T_b);

}  // namespace spool
