// The rigid motion of least squares between points and points, bare and quick.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/rigid_fit.h"

#include <cassert>

#include <Eigen/SVD>

namespace spool {

Pose fit_rigid_motion(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
  assert(from.size() == to.size() && from.size() >= 3 && "three pairs or more");
  Eigen::Vector3d from_mean = Eigen::Vector3d::Zero(), to_mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    from_mean += from[i];
    to_mean += to[i];
  }
  from_mean /= static_cast<double>(from.size());
  to_mean /= static_cast<double>(to.size());
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    cross += (to[i] - to_mean) * (from[i] - from_mean).transpose();
  // Umeyama 1991, eq. 40-43 with c = 1.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handed = svd.matrixU().determinant() * svd.matrixV().determinant();
  const Eigen::Vector3d signs(1, 1, handed < 0 ? -1 : 1);
  Pose T_to_from = Pose::Identity();
  T_to_from.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  T_to_from.translation() = to_mean - T_to_from.linear() * from_mean;
  return T_to_from;
}

}  // namespace spool
