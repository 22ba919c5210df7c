// The sensor's scale from pieces of known size: s(z) = 1 + a + b z by weighted least squares.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/gauge_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "vision/fit/distributions.h"

namespace spool {
namespace {

constexpr double kOtherSize = 0.04;  // as of pipes: neighbours in the catalogue differ by more
constexpr double kMany = 1e6;        // degrees of freedom at which Student's t is the normal

double own_u(const Gauge& gauge) { return std::hypot(gauge.tolerance_u_m, gauge.u_m); }

bool is_usable(const Gauge& gauge) {
  if (!(gauge.nominal_m > 0) || !(gauge.measured_m > 0) || !(own_u(gauge) > 0)) return false;
  const double off = std::abs(gauge.measured_m - gauge.nominal_m);
  return off < kOtherSize * gauge.nominal_m + 2 * std::hypot(own_u(gauge), gauge.shared_u_m);
}

bool is_of_two_parts(const std::vector<Gauge>& gauges) {
  return std::ranges::any_of(gauges,
                             [&](const Gauge& each) { return each.part != gauges.front().part; });
}

// Wilson & Hilferty: is a chi-square more than chance makes it once in twenty times?
bool scatters(double chi_square, int freedom) {
  if (freedom < 1) return false;
  const double spread = 2.0 / (9 * freedom);
  return (std::cbrt(chi_square / freedom) - (1 - spread)) / std::sqrt(spread) > 1.645;
}

// What the gauges alone say: the scale at their own mean range and its slope, uncorrelated there.
struct GaugeFit {
  double scale = 0, scale_variance = 0;
  double slope = 0, slope_variance = 0;  // 1/m
  bool has_slope = false;
  double mean_range_m = 0, nearest_m = 0, farthest_m = 0;
  double chi_square = 0;
  int freedom = 0;
};

GaugeFit fit_gauges(const std::vector<Gauge>& gauges) {
  const auto n = static_cast<Eigen::Index>(gauges.size());
  Eigen::VectorXd off(n), range = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Gauge& one = gauges[static_cast<std::size_t>(i)];
    off[i] = one.measured_m / one.nominal_m - 1;
    range[i] = one.range_m.value_or(0);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Gauge& other = gauges[static_cast<std::size_t>(j)];
      const double shared = one.kind == other.kind ? one.shared_u_m * other.shared_u_m : 0;
      const double own = i == j ? own_u(one) * own_u(one) : 0;
      covariance(i, j) = (own + shared) / (one.nominal_m * other.nominal_m);
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> weight(covariance);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n), weighed = weight.solve(ones);
  GaugeFit fit;
  fit.scale_variance = 1 / weighed.sum();
  fit.scale = fit.scale_variance * weighed.dot(off);
  fit.mean_range_m = fit.scale_variance * weighed.dot(range);
  fit.nearest_m = range.minCoeff();
  fit.farthest_m = range.maxCoeff();
  const Eigen::VectorXd away = range - fit.mean_range_m * ones, along = weight.solve(away);
  constexpr double kLeastSpread_m = 0.02;  // ranges nearer to each other are one
  fit.has_slope = fit.farthest_m - fit.nearest_m > kLeastSpread_m;
  if (fit.has_slope) {
    fit.slope_variance = 1 / along.dot(away);
    fit.slope = fit.slope_variance * along.dot(off);
  }
  const Eigen::VectorXd left = off - fit.scale * ones - fit.slope * away;
  fit.chi_square = left.dot(weight.solve(left));
  fit.freedom = static_cast<int>(n) - (fit.has_slope ? 2 : 1);
  if (scatters(fit.chi_square, fit.freedom)) {
    fit.scale_variance *= fit.chi_square / fit.freedom;
    fit.slope_variance *= fit.chi_square / fit.freedom;
  }
  return fit;
}

// Scale at the mean range, and slope, with their covariance.
struct Belief {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

Belief calibrated(double scale_u, const GaugeFit& fit) {
  Belief prior;
  prior.covariance(0, 0) = scale_u * scale_u;
  if (!fit.has_slope) return prior;
  const double cross = scale_u * scale_u / (2 * fit.mean_range_m);
  prior.covariance(0, 1) = prior.covariance(1, 0) = cross;
  prior.covariance(1, 1) = cross / fit.mean_range_m;
  return prior;
}

Belief of_gauges(const GaugeFit& fit) {
  Belief belief;
  belief.mean = {fit.scale, fit.slope};
  belief.covariance.diagonal() << fit.scale_variance, fit.slope_variance;
  return belief;
}

Belief together(const Belief& prior, const Belief& found, bool has_slope) {
  if (!has_slope) {
    const double sum = prior.covariance(0, 0) + found.covariance(0, 0);
    Belief both;
    both.mean[0] = prior.covariance(0, 0) / sum * found.mean[0];
    both.covariance(0, 0) = prior.covariance(0, 0) / sum * found.covariance(0, 0);
    return both;
  }
  // The gain's form holds for a prior of zero variance too.
  const Eigen::Matrix2d gain = prior.covariance * (prior.covariance + found.covariance).inverse();
  return {gain * found.mean, (Eigen::Matrix2d::Identity() - gain) * prior.covariance};
}

// The largest root mean square error of a scale of one over the gauges' ranges.
double left_u(const Belief& belief, const GaugeFit& fit, double corrected) {
  double most = 0;
  for (const double range : {fit.nearest_m, fit.farthest_m}) {
    const Eigen::Vector2d at(1, fit.has_slope ? range - fit.mean_range_m : 0);
    const double off = at.dot(belief.mean) - corrected;
    most = std::max(most, std::sqrt(std::max(0.0, at.dot(belief.covariance * at)) + off * off));
  }
  return most;
}

}  // namespace

std::optional<ScaleCheck> check_scale(std::span<const Gauge> gauges,
                                      const GaugeCheckOptions& options) {
  ScaleCheck check;
  std::ranges::copy_if(gauges, std::back_inserter(check.gauges), is_usable);
  if (check.gauges.empty()) return std::nullopt;
  // A range counts where every gauge has one.
  if (!std::ranges::all_of(check.gauges, [](const Gauge& g) { return g.range_m.has_value(); }))
    for (Gauge& gauge : check.gauges) gauge.range_m.reset();
  const GaugeFit fit = fit_gauges(check.gauges);
  const Belief prior = calibrated(options.scale_u, fit), found = of_gauges(fit);
  check.prior_u = options.scale_u;
  check.found = fit.scale;
  check.found_u = std::sqrt(fit.scale_variance);
  if (check.gauges.front().range_m) check.range_m = fit.mean_range_m;
  check.chi_square = fit.chi_square;
  check.freedom = fit.freedom;

  const int tests = fit.has_slope ? 2 : 1;
  check.false_alarm = options.false_alarm;
  check.limit = student_limit(1 - options.false_alarm / tests, kMany);
  for (int k = 0; k < tests; ++k)
    check.statistic =
        std::max(check.statistic, std::abs(found.mean[k]) /
                                      std::sqrt(prior.covariance(k, k) + found.covariance(k, k)));
  check.is_contradicted = check.statistic > check.limit && is_of_two_parts(check.gauges);

  const Belief last = check.is_contradicted ? found : together(prior, found, fit.has_slope);
  check.b_per_m = last.mean[1];
  check.a = last.mean[0] - last.mean[1] * fit.mean_range_m;
  const bool is_supported = std::abs(fit.scale) > check.limit * check.found_u;
  if (is_supported && !check.is_contradicted && is_of_two_parts(check.gauges))
    check.correction = last.mean[0];
  check.scale_u = left_u(last, fit, check.correction);
  return check;
}

}  // namespace spool
