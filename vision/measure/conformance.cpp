// How probable it is that what was measured lies within its tolerance (JCGM 106:2012).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/conformance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace spool {
namespace {

double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// `twentieth`, `thousandth`: what chance exceeds once in so many times, in standard deviations.
bool is_beyond(double size, double u, double tolerance, double twentieth, double thousandth) {
  return size >= tolerance + twentieth * u && size >= 0.5 * tolerance + thousandth * u;
}

}  // namespace

Verdict decide(const Conformance& conformance) {
  if (conformance.probability >= kProvedRight) return Verdict::kOk;
  return conformance.probability <= kProvedWrong && conformance.is_beyond ? Verdict::kNotOk
                                                                          : Verdict::kSuspicious;
}

Conformance conformance_of(double deviation, double u, double tolerance) {
  assert(u > 0 && tolerance >= 0);
  return {normal_below((tolerance - deviation) / u) - normal_below((-tolerance - deviation) / u),
          is_beyond(std::abs(deviation), u, tolerance, 1.645, 3.291)};
}

Conformance conformance_of(const Eigen::Vector2d& tilt, const Eigen::Matrix2d& covariance,
                           double tolerance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d sigma = solver.eigenvalues().cwiseMax(1e-18).cwiseSqrt();
  const Eigen::Vector2d middle = solver.eigenvectors().transpose() * tilt;
  // Strips across the first principal axis: the other integrates in closed form.
  constexpr int kStrips = 400;
  const double low = std::max(-tolerance, middle.x() - 8 * sigma.x());
  const double high = std::min(tolerance, middle.x() + 8 * sigma.x());
  const Eigen::Vector2d way = tilt.norm() > 0 ? Eigen::Vector2d(tilt.normalized())
                                              : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  const double u = std::sqrt(way.dot(covariance * way));
  const bool beyond = is_beyond(tilt.norm(), u, tolerance, 2.448, 3.717);
  if (!(high > low)) return {0, beyond};
  double sum = 0;
  const double width = (high - low) / kStrips;
  for (int i = 0; i < kStrips; ++i) {
    const double x = low + (i + 0.5) * width;
    const double half = std::sqrt(std::max(0.0, tolerance * tolerance - x * x));
    const double z = (x - middle.x()) / sigma.x();
    const double share = normal_below((half - middle.y()) / sigma.y()) -
                         normal_below((-half - middle.y()) / sigma.y());
    sum += share * std::exp(-0.5 * z * z);
  }
  return {std::min(1.0, sum * width / (sigma.x() * std::sqrt(2 * std::numbers::pi))), beyond};
}

}  // namespace spool
