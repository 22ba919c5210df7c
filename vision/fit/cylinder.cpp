// A cylinder through points: robust Gauss-Newton with the radius' prior as one more reading.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/cylinder.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "vision/core/median.h"

namespace spool {
namespace {

using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

constexpr double kTukey = 4.685;

double tukey_weight(double residual, double sigma) {
  const double share = residual / (kTukey * sigma);
  if (std::abs(share) >= 1) return 0;
  const double rest = 1 - share * share;
  return rest * rest;
}

// d(weight * residual) / d residual.
double tukey_slope(double residual, double sigma) {
  const double square = residual * residual / (kTukey * kTukey * sigma * sigma);
  return square >= 1 ? 0 : (1 - square) * (1 - 5 * square);
}

Eigen::Matrix3d frame_about(const Eigen::Vector3d& z) {
  Eigen::Matrix3d frame;
  frame.col(2) = z.normalized();
  frame.col(0) = frame.col(2).unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// The cylinder moved by the five of CylinderFit::error.
void move(const Vector5d& step, CylinderFit& fit) {
  Vector6d motion;
  motion << step[0], step[1], 0, step[2], step[3], 0;
  fit.T_points_cylinder = fit.T_points_cylinder * pose_from_small(motion);
  fit.radius_m += step[4];
}

// The origin goes along the axis to the middle of the points that count.
void centre_on(std::span<const Eigen::Vector3f> points, const std::vector<double>& weights,
               CylinderFit& fit) {
  double along = 0, sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    along += weights[i] * (points[i].cast<double>() - fit.centre()).dot(fit.axis());
    sum += weights[i];
  }
  if (sum > 0) fit.T_points_cylinder.translation() += along / sum * fit.axis();
}

struct Normal {
  Matrix5d information = Matrix5d::Zero();  // in units of one reading's variance
  Vector5d gradient = Vector5d::Zero();
  double weight = 0;
};

Normal normal_equations(std::span<const Eigen::Vector3f> points, const std::vector<double>& weights,
                        const CylinderFit& fit) {
  Normal normal;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    const Eigen::Vector3d point = points[i].cast<double>();
    const Vector5d row = fit.gradient(point);
    const double residual = fit.distance(point);
    normal.information += weights[i] * row * row.transpose();
    normal.gradient += weights[i] * residual * row;
    normal.weight += weights[i];
  }
  return normal;
}

// True where the points and the prior leave no direction of the five open. Rotations are taken at
// an arm of `lever` (m), so that all five are metres.
bool is_held(const Matrix5d& information, double lever) {
  Vector5d unit;
  unit << 1, 1, 1 / lever, 1 / lever, 1;
  const Matrix5d scaled = unit.asDiagonal() * information * unit.asDiagonal();
  const Vector5d values = Eigen::SelfAdjointEigenSolver<Matrix5d>(scaled).eigenvalues();
  // A direction that is known a thousand times worse than the best one is not measured.
  constexpr double kLeast = 1e-6;
  return values[0] > kLeast * values[4];
}

// What the fit rests on: rows of the points used, and the variance (m^2) that a reading is worth.
struct Evidence {
  Matrix5d rows = Matrix5d::Zero();
  double variance = 0;
  double residual_m = 0;  // standard deviation of the used points about the surface
};

// Huber 1981, 7.6: an M-estimate's covariance is (X'X)^-1 s^2 mean(psi^2) / mean(psi')^2.
Evidence evidence_of(std::span<const Eigen::Vector3f> points, const std::vector<double>& weights,
                     double sigma, std::size_t unknowns, const CylinderFit& fit) {
  Evidence evidence;
  double psi2 = 0, slope = 0, squares = 0, weight = 0;
  std::size_t used = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    const Eigen::Vector3d point = points[i].cast<double>();
    const double residual = fit.distance(point);
    const Vector5d row = fit.gradient(point);
    evidence.rows += row * row.transpose();
    psi2 += weights[i] * weights[i] * residual * residual;
    slope += tukey_slope(residual, sigma);
    squares += weights[i] * residual * residual;
    weight += weights[i];
    ++used;
  }
  if (used <= unknowns || !(slope > 0)) return evidence;
  const auto n = static_cast<double>(used);
  const double freedom = n - static_cast<double>(unknowns);
  evidence.variance = psi2 * n * n / (slope * slope * freedom);
  evidence.residual_m = std::sqrt(squares / weight * n / freedom);
  return evidence;
}

double spread_along(std::span<const Eigen::Vector3f> points, const std::vector<double>& weights,
                    const CylinderFit& fit) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    const double z = (points[i].cast<double>() - fit.centre()).dot(fit.axis());
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return high - low;
}

}  // namespace

double CylinderFit::distance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = T_points_cylinder.inverse() * point;
  return std::hypot(local.x(), local.y()) - radius_m;
}

Vector5d CylinderFit::gradient(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = T_points_cylinder.inverse() * point;
  const double across = std::max(1e-12, std::hypot(local.x(), local.y()));
  const double nx = local.x() / across, ny = local.y() / across;
  // Turned by a about x and b about y, the axis at height z moves by (b z, -a z).
  Vector5d row;
  row << nx, ny, -ny * local.z(), nx * local.z(), 1;
  return row;
}

CylinderFit fit_cylinder(std::span<const Eigen::Vector3f> points, const CylinderStart& start,
                         double noise_m) {
  assert(start.radius_m > 0 && start.radius_u_m >= 0 && noise_m >= 0);
  assert(std::abs(start.direction.norm() - 1) < 1e-6);
  std::vector<std::uint32_t> places;
  std::vector<Eigen::Vector3f> finite;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    places.push_back(static_cast<std::uint32_t>(i));
    finite.push_back(points[i]);
  }
  constexpr std::size_t kUnknowns = 5;
  if (finite.size() <= kUnknowns) return {};
  CylinderFit fit;
  fit.T_points_cylinder.linear() = frame_about(start.direction);
  fit.T_points_cylinder.translation() = start.point;
  fit.radius_m = start.radius_m;
  std::vector<double> weights(finite.size(), 1.0);
  centre_on(finite, weights, fit);

  const bool is_free = std::isinf(start.radius_u_m), is_fixed = start.radius_u_m == 0;
  Normal normal;
  Matrix5d information;
  double sigma = 0;
  constexpr int kRounds = 50;
  constexpr double kStill = 1e-9;  // m
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> off;
    for (const Eigen::Vector3f& p : finite) off.push_back(std::abs(fit.distance(p.cast<double>())));
    // 1.4826 turns the median of absolute normal deviations into a standard deviation; the tiny
    // share of the radius keeps points without noise from being cut by rounding.
    sigma = std::max({noise_m, 1.4826 * median(off), 1e-6 * start.radius_m});
    for (std::size_t i = 0; i < finite.size(); ++i)
      weights[i] = tukey_weight(fit.distance(finite[i].cast<double>()), sigma);
    centre_on(finite, weights, fit);
    normal = normal_equations(finite, weights, fit);
    information = normal.information;
    Vector5d gradient = normal.gradient;
    if (is_fixed) {
      information.row(4).setZero();
      information.col(4).setZero();
      information(4, 4) = normal.weight;
      gradient[4] = 0;
    } else if (!is_free) {
      const double prior = sigma * sigma / (start.radius_u_m * start.radius_u_m);
      information(4, 4) += prior;
      gradient[4] += prior * (start.radius_m - fit.radius_m);
    }
    const double length = spread_along(finite, weights, fit);
    if (!is_held(information, std::max(length / 2, start.radius_m))) return {};
    const Vector5d step = information.ldlt().solve(gradient);
    move(step, fit);
    if (!(fit.radius_m > 0)) return {};
    if (step.head<2>().norm() + length * step.segment<2>(2).norm() + std::abs(step[4]) < kStill)
      break;
  }
  for (std::size_t i = 0; i < finite.size(); ++i)
    if (weights[i] > 0) fit.inliers.push_back(places[i]);
  if (fit.inliers.size() * 2 < finite.size() || fit.inliers.size() <= kUnknowns) return {};
  const Evidence evidence =
      evidence_of(finite, weights, sigma, is_fixed ? kUnknowns - 1 : kUnknowns, fit);
  fit.sigma_m = std::max(noise_m, evidence.residual_m);
  const double least_m = 1e-9 * start.radius_m;  // points without any noise
  information = evidence.rows / std::max({noise_m * noise_m, evidence.variance, least_m * least_m});
  if (is_fixed) {
    information.row(4).setZero();
    information.col(4).setZero();
    information(4, 4) = 1;
  } else if (!is_free) {
    information(4, 4) += 1 / (start.radius_u_m * start.radius_u_m);
  }
  fit.error.covariance = information.ldlt().solve(Matrix5d::Identity());
  if (is_fixed) fit.error.covariance(4, 4) = 0;
  fit.is_determined = true;
  return fit;
}

}  // namespace spool
