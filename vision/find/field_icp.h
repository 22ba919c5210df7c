// A quick refinement of many rough poses: point-to-plane on the field's samples.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/cloud_view.h"
#include "vision/find/surface_field.h"

namespace spool {

struct FieldIcpOptions {
  int iterations = 20;
  double start_gate_m = 0.05;  // m; where the pose may be off by so much
  double end_gate_m = 0.01;    // m; the gate closes to this evenly over the iterations
};

struct FieldIcpResult {
  Eigen::Isometry3f T_design_scan = Eigen::Isometry3f::Identity();
  std::size_t inliers = 0;  // points within the last gate
  double rms_m = 0;         // of those, to the planes
};

// Refines T_guess so that `scan` (points, m; those off the design cost next to nothing) lies on the
// design's samples. Rough: the surface is the samples' tangent planes.
[[nodiscard]] FieldIcpResult refine_on_field(std::span<const Eigen::Vector3f> scan,
                                             const CloudView& samples, const SurfaceField& field,
                                             const Eigen::Isometry3f& T_guess,
                                             const FieldIcpOptions& options);

}  // namespace spool
