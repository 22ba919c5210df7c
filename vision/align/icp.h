// Iterative closest point, scan to design: point-to-plane, robust, honest about blind spots.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/align/weak_directions.h"
#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"
#include "vision/design/design_surface.h"

namespace spool {

struct IcpOptions {
  int max_iterations = 60;         // 0: only measures at the guess
  double start_distance_m = 0.05;  // m; correspondences are looked for this far at first…
  double noise_m = 0.003;          // m; …and in the end 3 times this or the residuals' own scale
  double max_normal_angle_rad = 1.05;  // rad; scan and design normal may differ by this where known
  bool oriented_normals = true;        // false: only the line of a normal counts, not its sign
  double trim_fraction = 0.0;          // share of the worst correspondences dropped each round
  double stop_translation_m = 1e-5;    // m; both steps smaller: converged
  double stop_rotation_rad = 1e-5;     // rad
};

// What makes no sense in `options`, kUsage; nothing where all is well.
[[nodiscard]] std::optional<Error> validate(const IcpOptions& options);

struct IcpResult {
  Pose T_design_scan = Pose::Identity();
  bool converged = false;
  int iterations = 0;
  std::size_t correspondences = 0;  // within the last gate
  double overlap = 0;               // correspondences over the finite points given
  double rms_m = 0;                 // point to surface, of the correspondences
  Matrix6d information =
      Matrix6d::Zero();  // of the last step, at the design origin, in points (1/m^2 of
                         // motion at unit residual variance), translation first
  Matrix6d covariance = Matrix6d::Zero();      // m, rad; huge along weak directions
  std::vector<WeakDirection> weak_directions;  // held at the guess
};

// Refines T_guess so that the scan's points (m, scan frame; normals optional) lie on the surface.
// Never estimates scale. Point-to-plane (Chen & Medioni 1992) with Tukey's biweight as wide as the
// gate, which follows the residuals' own scale (MAD, what lies evenly over the gate taken off) down
// to 3 noise_m at least; along weak directions (Zhang & Singh 2016) the design as a whole stays as
// near the guess as the held ones let it. A cancelled run
// returns what it has, not converged. Deterministic on any number of threads.
[[nodiscard]] IcpResult refine_icp(const CloudView& scan, const DesignSurface& surface,
                                   const Pose& T_guess, const IcpOptions& options = {},
                                   const Watch& watch = {});

}  // namespace spool
