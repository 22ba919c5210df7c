// Student's t and Fisher's F: what a regression's intervals and its test are read from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/fit/distributions.h"

#include <cassert>
#include <cmath>
#include <initializer_list>

namespace spool {

double regularised_beta(double x, double a, double b) {
  assert(a > 0 && b > 0 && x >= 0 && x <= 1 && "where the function is defined");
  if (x == 0 || x == 1) return x;
  // The fraction converges quickly on this side of the mean; I_x(a, b) = 1 - I_{1-x}(b, a).
  if (x > (a + 1) / (a + b + 2)) return 1 - regularised_beta(1 - x, b, a);
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x)) /
                       a;
  // Lentz's method: value = c/d ratios multiplied up, both kept away from zero.
  constexpr double kTiny = 1e-300;
  const auto away = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
  double c = 1, d = 1 / away(1 - (a + b) * x / (a + 1)), value = d;
  for (int m = 1; m < 500; ++m) {
    const double k = m;
    for (const double term : {k * (b - k) * x / ((a + 2 * k - 1) * (a + 2 * k)),
                              -(a + k) * (a + b + k) * x / ((a + 2 * k) * (a + 2 * k + 1))}) {
      d = 1 / away(1 + term * d);
      c = away(1 + term / c);
      value *= c * d;
    }
    if (std::abs(c * d - 1) < 1e-15) break;
  }
  return front * value;
}

double student_within(double t, double freedom) {
  assert(t >= 0 && freedom > 0);
  return 1 - regularised_beta(freedom / (freedom + t * t), freedom / 2, 0.5);
}

double student_limit(double confidence, double freedom) {
  assert(confidence > 0 && confidence < 1);
  double low = 0, high = 1;
  while (student_within(high, freedom) < confidence) high *= 2;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (student_within(middle, freedom) < confidence ? low : high) = middle;
  }
  return high;
}

double fisher_beyond(double f, double freedom_above, double freedom_below) {
  assert(f >= 0 && freedom_above > 0 && freedom_below > 0);
  return regularised_beta(freedom_below / (freedom_below + freedom_above * f), freedom_below / 2,
                          freedom_above / 2);
}

}  // namespace spool
