// What a depth camera's picture is bent by, as a polynomial over the picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace spool {

// A reading of true depth z reads z (1 + w(x, y)): x and y run from -1 to 1 between the picture's
// sides. w has the terms of degree two to four: a constant is scale, and linear ones are how a
// plane stands, so a flat wall tells neither (1/z of a plane is linear in x and y).
struct DepthWarp {
  static constexpr int kTerms = 12;
  using Terms = std::array<double, kTerms>;
  Terms share = {};  // of depth; x², xy, y², x³, x²y, xy², y³, x⁴, x³y, x²y², xy³, y⁴

  [[nodiscard]] static Terms terms(double x, double y) {
    const double x2 = x * x, y2 = y * y;
    return {x2,     x * y,   y2,         x2 * x,  x2 * y,     x * y2,
            y2 * y, x2 * x2, x2 * x * y, x2 * y2, x * y2 * y, y2 * y2};
  }
  [[nodiscard]] bool is_flat() const {
    return std::ranges::all_of(share, [](double c) { return c == 0; });
  }
  [[nodiscard]] double at(double x, double y) const {
    const Terms term = terms(x, y);
    double sum = 0;
    for (std::size_t k = 0; k < share.size(); ++k) sum += share[k] * term[k];
    return sum;
  }
  // w along one row of the picture: the polynomial's coefficients in x, lowest first.
  [[nodiscard]] std::array<double, 5> row(double y) const {
    const double y2 = y * y;
    return {share[2] * y2 + share[6] * y2 * y + share[11] * y2 * y2,
            share[1] * y + share[5] * y2 + share[10] * y2 * y,
            share[0] + share[4] * y + share[9] * y2, share[3] + share[8] * y, share[7]};
  }
  // No |w| is larger.
  [[nodiscard]] double most() const {
    double sum = 0;
    for (const double c : share) sum += std::abs(c);
    return sum;
  }
};

// Where between the picture's sides a pixel lies, -1 to 1 (its outer edges).
[[nodiscard]] inline double picture_share(double pixel, int side_px) {
  return (2 * pixel + 1) / side_px - 1;
}

}  // namespace spool
