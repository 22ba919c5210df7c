// A plane through points: total least squares, and the same after a least-median search.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "vision/core/median.h"

namespace spool {
namespace {

using Places = std::vector<std::uint32_t>;

Places finite_places(std::span<const Eigen::Vector3f> points) {
  Places places;
  places.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite()) places.push_back(static_cast<std::uint32_t>(i));
  return places;
}

PlaneFit fit_to(std::span<const Eigen::Vector3f> points, Places places, double noise_m) {
  PlaneFit fit;
  if (places.size() < 3) return fit;
  const auto n = static_cast<double>(places.size());
  // About the first point, in double: far-off coordinates must not eat the digits.
  const Eigen::Vector3d first = points[places.front()].cast<double>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : places) sum += points[i].cast<double>() - first;
  const Eigen::Vector3d centre = first + sum / n;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : places) {
    const Eigen::Vector3d offset = points[i].cast<double>() - centre;
    scatter += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d spread = solver.eigenvalues().cwiseMax(0.0);  // m^2 summed, ascending
  constexpr double kLine = 1e-10;  // a width of 1e-5 of the length is rounding, not a plane
  if (!(spread[2] > 0) || spread[1] <= kLine * spread[2]) return fit;

  const Eigen::Vector3d x = solver.eigenvectors().col(2);
  const Eigen::Vector3d z = solver.eigenvectors().col(0);
  fit.T_points_plane.linear().col(0) = x;
  fit.T_points_plane.linear().col(1) = z.cross(x);
  fit.T_points_plane.linear().col(2) = z;
  fit.T_points_plane.translation() = centre;
  fit.rms_m = std::sqrt(spread[0] / n);
  // Three parameters are spent: three points leave no residual and say nothing of their noise.
  const double residual_m = places.size() > 3 ? std::sqrt(spread[0] / (n - 3)) : 0.0;
  fit.sigma_m = std::max(noise_m, residual_m);
  // z = a + tilt_x y - tilt_y x has a diagonal normal matrix about the centre in the principal
  // axes.
  const double variance = fit.sigma_m * fit.sigma_m;
  fit.error.covariance.diagonal() =
      Eigen::Vector3d(variance / n, variance / spread[1], variance / spread[2]);
  fit.inliers = std::move(places);
  fit.is_determined = true;
  return fit;
}

struct Plane {
  Eigen::Vector3d normal;
  double offset;  // normal . p
  [[nodiscard]] double distance(const Eigen::Vector3f& point) const {
    return std::abs(normal.dot(point.cast<double>()) - offset);
  }
};

std::optional<Plane> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double length = normal.norm();
  if (!(length > 1e-6 * (b - a).norm() * (c - a).norm())) return std::nullopt;  // on a line
  return Plane{normal / length, normal.dot(a) / length};
}

// Median of |distance| over `places`; `scratch` is overwritten.
double median_distance(const Plane& plane, std::span<const Eigen::Vector3f> points,
                       const Places& places, std::vector<double>& scratch) {
  scratch.clear();
  for (const std::uint32_t i : places) scratch.push_back(plane.distance(points[i]));
  return median(scratch);
}

}  // namespace

PlaneFit fit_plane(std::span<const Eigen::Vector3f> points, double noise_m) {
  return fit_to(points, finite_places(points), noise_m);
}

PlaneFit fit_plane_robustly(std::span<const Eigen::Vector3f> points,
                            const RobustPlaneOptions& options) {
  assert(options.samples > 0 && options.inlier_sigmas > 0 && options.noise_m >= 0);
  const Places all = finite_places(points);
  if (all.size() < 3) return {};
  // A thousand of them tell the median as well as all do.
  constexpr std::size_t kEnough = 1000;
  Places some;
  for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / kEnough) some.push_back(all[i]);

  std::mt19937 random(options.seed);
  const auto draw = [&] { return points[all[random() % all.size()]].cast<double>().eval(); };
  std::optional<Plane> best;
  double best_median = 0;
  std::vector<double> scratch;
  for (int i = 0; i < options.samples; ++i) {
    const Eigen::Vector3d a = draw(), b = draw(), c = draw();
    const auto plane = through(a, b, c);
    if (!plane) continue;
    const double median = median_distance(*plane, points, some, scratch);
    if (!best || median < best_median) {
      best = plane;
      best_median = median;
    }
  }
  if (!best) return {};

  // 1.4826 turns the median of absolute normal deviations into a standard deviation; the tiny share
  // of the cloud's own size keeps points without noise from being cut by rounding.
  const double size = (points[all.front()] - points[all.back()]).cast<double>().norm();
  const double sigma = std::max({options.noise_m, 1.4826 * best_median, 1e-7 * size});
  PlaneFit fit;
  Places inliers;
  Plane plane = *best;
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    Places near;
    for (const std::uint32_t i : all)
      if (plane.distance(points[i]) <= options.inlier_sigmas * sigma) near.push_back(i);
    if (near == inliers) break;
    inliers = near;
    fit = fit_to(points, std::move(near), options.noise_m);
    if (!fit.is_determined) return {};
    plane = {fit.normal(), fit.normal().dot(fit.centre())};
  }
  if (inliers.size() * 2 < all.size()) return {};
  return fit;
}

}  // namespace spool
