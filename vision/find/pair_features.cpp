// What an oriented pair of points looks like from anywhere: three angles, and the cell they fall
// in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/pair_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spool {
namespace {

float angle_of_cosine(float cosine) { return std::acos(std::clamp(cosine, -1.0F, 1.0F)); }

}  // namespace

Eigen::Array3f pair_feature(const Eigen::Vector3f& p1, const Eigen::Vector3f& n1,
                            const Eigen::Vector3f& p2, const Eigen::Vector3f& n2) {
  const Eigen::Vector3f d = (p2 - p1).normalized();
  return {angle_of_cosine(n1.dot(d)), angle_of_cosine(n2.dot(d)),  // Equation (4.1)
          angle_of_cosine(n1.dot(n2))};
}

bool fixes_a_pose(const Eigen::Array3f& feature, double limit_rad) {
  const auto sine = static_cast<float>(std::sin(limit_rad));
  return std::sin(feature[0]) > sine || std::sin(feature[1]) > sine;
}

FeatureCells::FeatureCells(double cell_rad)
    : cell_rad_(cell_rad),
      // A quotient that rounding puts just over a whole number is that number.
      per_axis_(static_cast<std::size_t>(std::ceil(std::numbers::pi / cell_rad - 1e-9))) {
  assert(cell_rad > 0 && cell_rad <= std::numbers::pi && "a cell is an angle");
}

std::size_t FeatureCells::cell_of(const Eigen::Array3f& feature) const {
  const auto along = [&](Eigen::Index axis) {
    return std::min(static_cast<std::size_t>(feature[axis] / cell_rad_), per_axis_ - 1);
  };
  return (along(0) * per_axis_ + along(1)) * per_axis_ + along(2);
}

}  // namespace spool
