// A number with its doubt: value and covariance together.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace spool {

// N numbers (metres and radians) and their covariance.
template <int N>
struct Estimate {
  Eigen::Matrix<double, N, 1> value = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();

  // Standard uncertainty u of element `i`.
  [[nodiscard]] double u(int i) const { return std::sqrt(covariance(i, i)); }
};

}  // namespace spool
