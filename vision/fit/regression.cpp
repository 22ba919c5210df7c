// Linear regression by least squares, with everything that says how much to believe it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/regression.h"

#include <cassert>
#include <cmath>

#include <Eigen/QR>

#include "vision/fit/distributions.h"

namespace spool {

Regression regress(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& y) {
  assert(inputs.rows() == y.size() && "an observation a row");
  const Eigen::Index n = inputs.rows(), k = inputs.cols() + 1;
  Regression fit;
  fit.coefficients = fit.low = fit.high = Eigen::VectorXd::Zero(k);
  if (n <= k || !inputs.allFinite() || !y.allFinite()) return fit;
  Eigen::MatrixXd design(n, k);
  design << Eigen::VectorXd::Ones(n), inputs;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
  if (qr.rank() < k) return fit;

  fit.is_determined = true;
  fit.coefficients = qr.solve(y);
  const Eigen::VectorXd residuals = y - design * fit.coefficients;
  fit.residual_squares = residuals.squaredNorm();
  fit.sum_of_squares = (y.array() - y.mean()).square().sum();
  const auto freedom = static_cast<double>(n - k);
  const double variance = fit.residual_squares / freedom;
  const Eigen::MatrixXd inverse =
      (design.transpose() * design).ldlt().solve(Eigen::MatrixXd::Identity(k, k));
  const Eigen::VectorXd half =
      student_limit(0.95, freedom) * (variance * inverse.diagonal()).cwiseSqrt();
  fit.low = fit.coefficients - half;
  fit.high = fit.coefficients + half;
  if (!(fit.sum_of_squares > 0)) return fit;  // nothing varies: nothing to explain

  fit.r_squared = 1 - fit.residual_squares / fit.sum_of_squares;
  fit.adjusted_r_squared = 1 - variance / (fit.sum_of_squares / static_cast<double>(n - 1));
  if (k > 1) {
    const auto slopes = static_cast<double>(k - 1);
    fit.f = (fit.sum_of_squares - fit.residual_squares) / slopes / variance;
    fit.p = std::isfinite(fit.f) ? fisher_beyond(std::max(fit.f, 0.0), slopes, freedom) : 0;
  }
  // A residual without its own observation: divided by one less its leverage.
  double press = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double leverage = design.row(i) * inverse * design.row(i).transpose();
    press += std::pow(residuals[i] / (1 - leverage), 2);
  }
  fit.left_out_r_squared = 1 - press / fit.sum_of_squares;
  return fit;
}

}  // namespace spool
