// A plane through points, with what is known of its place and tilt.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/estimate.h"
#include "vision/core/pose.h"

namespace spool {

struct PlaneFit {
  // Plane to the points' frame: origin at the middle of the points used, x along their longest
  // spread, z the normal (its sign means nothing).
  Pose T_points_plane = Pose::Identity();
  // How far the true plane may be from this one, seen at that origin: shift along z (m), rotation
  // about x and about y (rad). The value is zero; the three are uncorrelated there. Points count as
  // independent: neighbours of a depth camera are not, and the caller divides their number
  // accordingly (ARCHITECTURE, The sensor).
  Estimate<3> error;
  double sigma_m = 0;                  // m, standard deviation of the used points about the plane
  double rms_m = 0;                    // m, of the used points' distances
  std::vector<std::uint32_t> inliers;  // places in the input of the points used, ascending
  // False where there are fewer than three finite points or they lie on a line (or, for the robust
  // fit, where no plane holds half of them): all else is then zero or the identity.
  bool is_determined = false;

  [[nodiscard]] Eigen::Vector3d normal() const { return T_points_plane.linear().col(2); }
  [[nodiscard]] Eigen::Vector3d centre() const { return T_points_plane.translation(); }
  // Signed distance (m) of a point, + on the normal's side.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
    return normal().dot(point - centre());
  }
};

// Total least squares over all finite points: the plane of least squared distances. `noise_m`: what
// is known of one point's standard deviation (m); the uncertainty comes from the larger of it and
// the residuals.
[[nodiscard]] PlaneFit fit_plane(std::span<const Eigen::Vector3f> points, double noise_m = 0);

struct RobustPlaneOptions {
  double noise_m = 0;  // m, known standard deviation of a point; 0: from the points themselves
  double inlier_sigmas = 3;  // points further off are no part of the plane
  int samples =
      200;  // triples tried: with half of the points outside, 1 - (7/8)^200 finds the plane
  std::uint32_t seed = 1;
};

// The plane that most of the points lie on: the triple with the least median distance, then least
// squares over the points near it, repeated until they stay the same. Good while under half of them
// lie elsewhere.
[[nodiscard]] PlaneFit fit_plane_robustly(std::span<const Eigen::Vector3f> points,
                                          const RobustPlaneOptions& options = {});

}  // namespace spool
