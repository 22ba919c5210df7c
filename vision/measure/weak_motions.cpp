// Which motions a covariance leaves open, in words where they are known ones.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/weak_motions.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace spool {
namespace {

constexpr double kWeak = 0.1 * kUnobservedSigma;
constexpr double kInSpace = 0.02;  // of a unit motion may lie outside
constexpr double kSpanned = 0.1;   // less of it than this is new: it was said before

}  // namespace

Vector6d shift_along(const Pose& frame, int axis) {
  Vector6d motion = Vector6d::Zero();
  motion.head<3>() = frame.linear().col(axis);
  return motion;
}

Vector6d turn_about(const Pose& frame) {
  const Eigen::Vector3d z = frame.linear().col(2);
  Vector6d motion;
  motion << frame.translation().cross(z), z;
  return motion;
}

std::vector<WeakMotion> weak_motions(const Matrix6d& covariance,
                                     const std::vector<NamedMotion>& named) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(covariance);
  Matrix6d open = Matrix6d::Zero();  // projects on what is open and not told yet
  int left = 0;
  for (int k = 0; k < 6; ++k) {
    if (eigen.eigenvalues()[k] < kWeak * kWeak) continue;
    open += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose();
    ++left;
  }
  const Matrix6d all_open = open;
  std::vector<WeakMotion> weak;
  const auto tell = [&](const Vector6d& direction, const std::string& text) {
    const double sigma = std::sqrt(direction.dot(covariance * direction));
    weak.push_back({direction, sigma, text});
    const Vector6d fresh = (open * direction).normalized();
    open -= fresh * fresh.transpose();
    --left;
  };
  for (const NamedMotion& each : named) {
    const Vector6d unit = each.motion.normalized();
    if (left == 0 || (unit - all_open * unit).norm() > kInSpace || (open * unit).norm() < kSpanned)
      continue;
    tell(unit, each.text);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6d> rest(open);
  for (int k = 5; left > 0; --k) tell(rest.eigenvectors().col(k), "a motion that no feature holds");
  return weak;
}

}  // namespace spool
