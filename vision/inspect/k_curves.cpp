// How noise and void rate go with K: the thesis's trend lines and where they cross (5.3.4, 5.4).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/k_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "vision/fit/regression.h"

namespace spool {
namespace {

Regression line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  return regress(Eigen::Map<const Eigen::VectorXd>(x.data(), n),
                 Eigen::Map<const Eigen::VectorXd>(y.data(), n));
}

}  // namespace

double LogCurve::at(double k) const { return a * std::log(k) + b; }   // Equation (5.3)
double PowerCurve::at(double k) const { return a * std::pow(k, b); }  // Equation (5.4)

LogCurve fit_log_curve(std::span<const double> k, std::span<const double> rate) {
  assert(k.size() == rate.size() && "a rate for every K");
  std::vector<double> x, y;
  for (std::size_t i = 0; i < k.size(); ++i) {
    x.push_back(std::log(k[i]));
    y.push_back(rate[i]);
  }
  const Regression line = line_through(x, y);
  if (!line.is_determined) return {};
  return {line.coefficients[1], line.coefficients[0], line.r_squared};
}

PowerCurve fit_power_curve(std::span<const double> k, std::span<const double> rate) {
  assert(k.size() == rate.size() && "a rate for every K");
  std::vector<double> x, y;
  for (std::size_t i = 0; i < k.size(); ++i) {
    if (!(rate[i] > 0)) continue;
    x.push_back(std::log(k[i]));
    y.push_back(std::log(rate[i]));
  }
  const Regression line = line_through(x, y);
  if (!line.is_determined) return {};
  return {std::exp(line.coefficients[0]), line.coefficients[1], line.r_squared};
}

KCrossing cross(const LogCurve& noise, const PowerCurve& lost) {
  KCrossing crossing;
  // noise - lost rises all the way over x = ln K where both parts do: a > 0 and a' b' < 0.
  if (!(noise.a > 0 && lost.a * lost.b < 0 && std::isfinite(noise.b))) {
    crossing.doubt = "the noise rate has to rise with K and the void rate to fall";
    return crossing;
  }
  const auto difference = [&](double x) {
    return noise.a * x + noise.b - lost.a * std::exp(lost.b * x);
  };
  // From minus to plus infinity; an exponential that overflows keeps its sign.
  double low = -1, high = 1;
  while (difference(low) > 0 && std::isfinite(low)) low *= 2;
  while (difference(high) < 0 && std::isfinite(high)) high *= 2;
  if (!std::isfinite(low) || !std::isfinite(high)) return crossing;
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) break;
    (difference(middle) < 0 ? low : high) = middle;
  }
  crossing.k = std::exp(high);
  crossing.rate = noise.at(crossing.k);
  crossing.exists = std::isfinite(crossing.k) && crossing.k > 0;
  if (!crossing.exists)
    crossing.doubt = "the curves cross beyond any K";
  else if (!(lost.a > 0))
    crossing.doubt = "the void rate is negative there";
  else if (!(crossing.rate <= 1))
    crossing.doubt = "as much is lost as there is";
  return crossing;
}

int k_by_crossing(const LogCurve& noise, const PowerCurve& lost) {
  const KCrossing crossing = cross(noise, lost);
  if (!crossing.exists || !crossing.doubt.empty()) return 0;
  return static_cast<int>(std::clamp(std::round(crossing.k), 1.0, 1e9));
}

}  // namespace spool
