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
  // The most that interpolation is off by in a cell's middle; a kFurtherOff-th of it beyond near_m,
  // nothing of it beyond band_m.
  float error_m = 0;
};

// What a brick may be off by: `tolerance_m` within `near_m` of the surface, kFurtherOff times as
// much up to `band_m`.
struct BrickLimits {
  float tolerance_m = 0;
  float near_m = 0;
  float band_m = 0;
};
inline constexpr float kFurtherOff = 5;
inline constexpr float kHalfDiagonal = 0.8661F;  // of a cube of side 1, rounded up

// `spacing_m`: from texel to texel. One piece of surface where that is within the limits, else
// two if that is nearer: where the distance has a crease, the places on either side of it are told
// apart by their gradients, and each side's distance is carried on over the crease along its
// gradient. Pure.
[[nodiscard]] DistanceBrick make_brick(const BrickTexels& texels, const BrickMiddles& middles,
                                       float spacing_m, const BrickLimits& limits);

// One piece of surface, however far off it is. Pure.
[[nodiscard]] DistanceBrick make_plain_brick(const BrickTexels& texels);

}  // namespace spool
