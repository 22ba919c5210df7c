// Linear regression by least squares, with everything that says how much to believe it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace spool {

// y = intercept + slopes . x, in the units of what was given.
struct Regression {
  // False where there are no more observations than coefficients, something is not finite, or the
  // inputs are constant or depend on one another: all else is then zero.
  bool is_determined = false;
  Eigen::VectorXd coefficients;  // the intercept, then one slope an input
  Eigen::VectorXd low, high;     // of each coefficient's 95 % interval (Student's t)
  double sum_of_squares = 0;     // SST, about the mean
  double residual_squares = 0;   // SSE
  double r_squared = 0;          // 1 - SSE / SST
  double adjusted_r_squared = 0;
  double f = 0;                   // of all slopes against none
  double p = 1;                   // of so large an F by chance
  double left_out_r_squared = 0;  // 1 - PRESS / SST: each observation predicted from the others

  [[nodiscard]] double predict(const Eigen::VectorXd& inputs) const {
    return coefficients[0] + coefficients.tail(inputs.size()).dot(inputs);
  }
};

// One observation a row of `inputs` and of `y`.
[[nodiscard]] Regression regress(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& y);

}  // namespace spool
