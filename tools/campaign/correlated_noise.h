// Noise over an image in which neighbours go along: what a sensor's correlation window leaves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "tools/campaign/random.h"

namespace spool::campaign {

// Mean 0, standard deviation 1 at every pixel; all but independent 8 px apart, as windows of 7 to 9
// px are. White noise at knots 4 px apart, between them weighted to keep the deviation.
class CorrelatedNoise {
 public:
  CorrelatedNoise(std::uint32_t seed, int field)
      : seed_(seed), field_(static_cast<std::uint64_t>(field)) {}

  [[nodiscard]] double at(double u, double v) const {
    constexpr double kKnot = 4;
    const double column = std::floor(u / kKnot);
    const double row = std::floor(v / kKnot);
    const double x = u / kKnot - column;
    const double y = v / kKnot - row;
    double sum = 0;
    double weight2 = 0;
    for (int i = 0; i <= 1; ++i)
      for (int j = 0; j <= 1; ++j) {
        const double weight = (i == 0 ? 1 - x : x) * (j == 0 ? 1 - y : y);
        sum += weight * knot(static_cast<int>(column) + i, static_cast<int>(row) + j);
        weight2 += weight * weight;
      }
    return sum / std::sqrt(weight2);
  }

 private:
  [[nodiscard]] double knot(int column, int row) const {
    const auto place = static_cast<std::uint64_t>((row + 1) * 4096 + column + 1);
    return Random(seed_ ^ 0x5EED'0000U, field_ << 32 | place).normal();
  }

  std::uint32_t seed_;
  std::uint64_t field_;
};

}  // namespace spool::campaign
