// Real roots of small polynomials, safely: between the roots of its derivative a polynomial is
// monotone.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace spool::campaign {

// Coefficients from the constant upwards; the roots in [low, high] in rising order, `count` of
// them. A double root that rounding keeps from crossing zero is not found: a ray that only just
// touches.
template <std::size_t Degree>
struct Roots {
  std::array<double, Degree> at = {};
  std::size_t count = 0;
};

template <std::size_t Degree>
[[nodiscard]] double polynomial(const std::array<double, Degree + 1>& c, double t) {
  double sum = c[Degree];
  for (std::size_t i = Degree; i-- > 0;) sum = sum * t + c[i];
  return sum;
}

template <std::size_t Degree>
[[nodiscard]] Roots<Degree> roots_between(const std::array<double, Degree + 1>& c, double low,
                                          double high) {
  Roots<Degree> roots;
  if constexpr (Degree == 1) {
    if (c[1] == 0) return roots;
    const double t = -c[0] / c[1];
    if (t >= low && t <= high) roots.at[roots.count++] = t;
  } else {
    std::array<double, Degree> slope;
    for (std::size_t i = 0; i < Degree; ++i) slope[i] = static_cast<double>(i + 1) * c[i + 1];
    const Roots<Degree - 1> turns = roots_between<Degree - 1>(slope, low, high);
    double from = low;
    double value = polynomial<Degree>(c, from);
    for (std::size_t piece = 0; piece <= turns.count; ++piece) {
      const double to = piece < turns.count ? turns.at[piece] : high;
      const double end = polynomial<Degree>(c, to);
      if ((value < 0) != (end < 0)) {
        // Newton's steps where they stay between the brackets, halving where they do not.
        double a = from, b = to, t = 0.5 * (from + to);
        for (int step = 0; step < 60 && b - a > 1e-14 * (1 + std::abs(t)); ++step) {
          const double f = polynomial<Degree>(c, t);
          if ((f < 0) == (value < 0))
            a = t;
          else
            b = t;
          const double next = t - f / polynomial<Degree - 1>(slope, t);
          const double moved = std::abs(next - t);
          t = next > a && next < b ? next : 0.5 * (a + b);
          if (moved < 1e-13) break;
        }
        roots.at[roots.count++] = t;
      }
      from = to;
      value = end;
    }
  }
  return roots;
}

}  // namespace spool::campaign
