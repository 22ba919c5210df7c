// Iterative closest point, scan to design: point-to-plane, robust, trimmed, and honest about what it cannot see.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/design/design_surface.h"

namespace spool {

struct IcpOptions {
  int max_iterations = 60;
  double start_distance_m = 0.05;   // m; correspondences are looked for this far at first…
  double noise_m = 0.003;           // m; …and in the end this times 3 (the gate shrinks with the residual)
  double max_normal_angle_rad = 1.05;  // rad; scan and design normal may differ by this where both are known
  double trim_fraction = 0.0;       // share of the worst correspondences dropped each round
  double stop_translation_m = 1e-6; // m; both steps smaller: converged
  double stop_rotation_rad = 1e-6;  // rad
};

// A direction of motion (unit 6-vector: translation over the length scale, rotation) the data does not hold.
struct WeakDirection {
  Vector6d direction = Vector6d::Zero();
  double sigma = 0;  // standard deviation along it (m at the length scale)
  std::string text;  // "sliding along (0, 0, 1)", "turning about …"
};

struct IcpResult {
  Pose T_design_scan = Pose::Identity();
  bool converged = false;
  int iterations = 0;
  std::size_t correspondences = 0;  // within the last gate
  double overlap = 0;               // correspondences over the points given
  double rms_m = 0;                 // point to surface, of the correspondences
  Matrix6d information = Matrix6d::Zero();  // of the last step, at the design origin, translation first
  Matrix6d covariance = Matrix6d::Zero();   // m, rad; huge along weak directions
  std::vector<WeakDirection> weak_directions;  // held at the guess
};

// Refines T_guess so that the scan's points (m, scan frame; normals optional) lie on the surface.
// Never estimates scale. Point-to-plane with a robust kernel whose width follows the residuals' own
// scale (MAD); weak directions keep the guess (Zhang & Singh 2016). Deterministic.
[[nodiscard]] IcpResult refine_icp(const CloudView& scan, const DesignSurface& surface, const Pose& T_guess,
                                   const IcpOptions& options = {}, const Watch& watch = {});

}  // namespace spool
