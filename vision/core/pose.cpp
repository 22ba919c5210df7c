// Rigid poses: rotation vectors, small motions, the row-major form of files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace spool {

Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle < 1e-300) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  // By way of the quaternion: well conditioned both near zero and near pi.
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

Pose pose_from_small(const Vector6d& small) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_vector(small.tail<3>());
  pose.translation() = small.head<3>();
  return pose;
}

PoseSize pose_size(const Pose& pose) {
  return {pose.translation().norm(), rotation_vector(pose.linear()).norm()};
}

std::array<double, 16> row_major(const Pose& pose) {
  std::array<double, 16> numbers{};
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data()) = pose.matrix();
  return numbers;
}

std::optional<Pose> pose_from_row_major(std::span<const double> numbers) {
  if (numbers.size() != 16) return std::nullopt;
  const Eigen::Matrix4d m =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  constexpr double kRigid = 1e-4;  // files print poses to five or six digits
  if (!m.allFinite()) return std::nullopt;
  if ((m.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > kRigid)
    return std::nullopt;
  const Eigen::Matrix3d r = m.topLeftCorner<3, 3>();
  if ((r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > kRigid)
    return std::nullopt;
  if (r.determinant() < 0) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Pose pose = Pose::Identity();
  pose.linear() = svd.matrixU() * svd.matrixV().transpose();
  pose.translation() = m.topRightCorner<3, 1>();
  return pose;
}

double largest_sigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace spool
