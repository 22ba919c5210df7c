// Rigid poses T_a_b (b's coordinates into a's), their small motions and covariance order.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace spool {

using Pose = Eigen::Isometry3d;
using Vector6d =
    Eigen::Matrix<double, 6, 1>;  // translation (m) first, rotation vector (rad) second
using Matrix6d = Eigen::Matrix<double, 6, 6>;  // covariance or information in the same order

// The rotation about `rotation_vector` (rad, right-handed) as a matrix; exact near zero and at pi.
[[nodiscard]] Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector);

// The rotation vector (rad, length in [0, pi]) of a rotation matrix; inverse of the above.
[[nodiscard]] Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation);

// The pose that moves by `small.head<3>()` (m) after turning by `small.tail<3>()` (rad).
[[nodiscard]] Pose pose_from_small(const Vector6d& small);

// The largest standard deviation along any direction, of a covariance of three coordinates: of the
// upper left block of a pose's in m, of the lower right one in rad.
[[nodiscard]] double largest_sigma(const Eigen::Matrix3d& covariance);

// Length (m) of the translation and angle (rad) of the rotation of `pose`.
struct PoseSize {
  double translation_m = 0;
  double rotation_rad = 0;
};
[[nodiscard]] PoseSize pose_size(const Pose& pose);

// The row-major 4x4 of a pose, as files and reports hold it.
[[nodiscard]] std::array<double, 16> row_major(const Pose& pose);

// The pose of 16 row-major numbers; nothing where they are not finite, not rigid to 1e-4 (a scale,
// a mirror or a shear) or the last row is not 0 0 0 1. The rotation is made exactly orthonormal.
[[nodiscard]] std::optional<Pose> pose_from_row_major(std::span<const double> numbers);

}  // namespace spool
