// How noise and void rate go with K: the thesis's trend lines and where they cross (5.3.4, 5.4).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace spool {

// Y = a ln K + b, eq. 5.3. The thesis says void rate; its numbers are the noise rate's (THESIS.md,
// A6).
struct LogCurve {
  double a = 0, b = 0;
  double r_squared = 0;
  [[nodiscard]] double at(double k) const;
};

// Y = a K^b, eq. 5.4; by its numbers the void rate's.
struct PowerCurve {
  double a = 0, b = 0;
  double r_squared = 0;  // of ln Y on ln K, as trend lines are fitted
  [[nodiscard]] double at(double k) const;
};

// Least squares of the rate on ln K. As many of both; K over 0. All zero where they do not
// determine a curve (fewer than three, or one K).
[[nodiscard]] LogCurve fit_log_curve(std::span<const double> k, std::span<const double> rate);

// Least squares of ln rate on ln K; rates that are not over 0 have no logarithm and are left out.
[[nodiscard]] PowerCurve fit_power_curve(std::span<const double> k, std::span<const double> rate);

struct KCrossing {
  bool exists = false;  // the curves cross, and but once
  double k = 0;         // where; may be anything over 0
  double rate = 0;      // of both there
  std::string doubt;    // why this K is not to be used, one sentence; empty where it may be
};

// The K at which as much is lost as is wrongly kept: noise (5.3) rises, void (5.4) falls, so that
// they cross once; found by bisection of their difference over ln K, to a double's precision,
// whatever the coefficients.
[[nodiscard]] KCrossing cross(const LogCurve& noise, const PowerCurve& lost);

// The whole K of a crossing, at least 1; 0 where there is none or it has a doubt.
[[nodiscard]] int k_by_crossing(const LogCurve& noise, const PowerCurve& lost);

}  // namespace spool
