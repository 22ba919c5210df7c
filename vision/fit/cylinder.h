// A cylinder through points, its radius known beforehand, with what is known of its axis.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/estimate.h"
#include "vision/core/pose.h"

namespace spool {

// Where a cylinder is looked for, and what is known of its radius. The start may be off by some
// tenths of the radius and some ten degrees.
struct CylinderStart {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       // m, on the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit
  double radius_m = 0;
  // Standard uncertainty (m) of that radius: a catalogue's tolerance. 0 holds it; infinity frees
  // it.
  double radius_u_m = 0;
};

struct CylinderFit {
  // Cylinder to the points' frame: z the axis, the way of the start's direction; the origin on the
  // axis at the middle of the points used.
  Pose T_points_cylinder = Pose::Identity();
  double radius_m = 0;
  // How far the true cylinder may be from this one: shift along x and y (m), rotation about x and y
  // (rad), all at that origin, and radius (m). Sliding along the axis and turning about it change
  // nothing and are no part of it. Points count as independent: see PlaneFit.
  Estimate<5> error;
  double sigma_m = 0;                  // m, standard deviation of the used points about the surface
  std::vector<std::uint32_t> inliers;  // places in the input of the points used, ascending
  // False where the points leave one of axis and radius unknown (too few of them, or all on one
  // line of the surface), or where no cylinder near the start holds half of them.
  bool is_determined = false;

  [[nodiscard]] Eigen::Vector3d axis() const { return T_points_cylinder.linear().col(2); }
  [[nodiscard]] Eigen::Vector3d centre() const { return T_points_cylinder.translation(); }
  // Signed distance (m) of a point, + outside.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;
  // By how much (m, m/rad) that distance falls as the cylinder moves by `error`'s five.
  [[nodiscard]] Eigen::Matrix<double, 5, 1> gradient(const Eigen::Vector3d& point) const;
};

// Least squares of the distances to the surface under Tukey's weights (4.685 standard deviations:
// 95 % as efficient as least squares on normal noise), by Gauss-Newton from the start; the radius'
// prior is one more reading. `noise_m`: what is known of one point's standard deviation (m); the
// uncertainty comes from the larger of it and the residuals.
[[nodiscard]] CylinderFit fit_cylinder(std::span<const Eigen::Vector3f> points,
                                       const CylinderStart& start, double noise_m = 0);

}  // namespace spool
