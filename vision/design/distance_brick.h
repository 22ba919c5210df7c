// What one brick of a distance volume holds: two smooth distances whose lesser is the true one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "vision/core/distance_volume.h"

namespace spool {

// The exact distance at a place, and its gradient.
struct DistanceSample {
  float distance_m = 0;                               // + outside
  Eigen::Vector3f outward = Eigen::Vector3f::Zero();  // unit
};

// Places of a brick: texels, and the middles of the cells between them; x runs fastest.
inline constexpr std::size_t kBrickSide = DistanceVolume::kBrickTexels;
inline constexpr std::size_t kBrickCells = kBrickSide - 1;
using BrickTexels = std::array<DistanceSample, kBrickSide * kBrickSide * kBrickSide>;
using BrickMiddles = std::array<DistanceSample, kBrickCells * kBrickCells * kBrickCells>;

struct DistanceBrick {
  std::array<std::array<Eigen::half, 2>, kBrickSide * kBrickSide * kBrickSide> texels;
  float error_m = 0;  // the most that interpolation is off by in a cell's middle, within the band
};

// `spacing_m`: from texel to texel. One piece of surface where that is within `tolerance_m`, else
// two if that is nearer: where the distance has a crease, the places on either side of it are told
// apart by their gradients, and each side's distance is carried on over the crease along its
// gradient. Pure.
[[nodiscard]] DistanceBrick make_brick(const BrickTexels& texels, const BrickMiddles& middles,
                                       float spacing_m, float band_m, float tolerance_m);

// One piece of surface, however far off it is. Pure.
[[nodiscard]] DistanceBrick make_plain_brick(const BrickTexels& texels);

}  // namespace spool
