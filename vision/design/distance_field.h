// A design's signed distance as a volume for the graphics card, as fine as its shape needs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Geometry>

#include "vision/core/cancel.h"
#include "vision/core/distance_volume.h"
#include "vision/design/design_surface.h"

namespace spool {

struct DistanceFieldOptions {
  float band_m = 0.03F;  // m from the surface: as far as it is known
  float near_m = 0.02F;  // m from the surface: as far as it is exact
  // m; a cube is divided where interpolation is off by more in the middle of a cell, beyond near_m
  // by kFurtherOff times as much. Elsewhere in a cell it can be off by half as much again.
  float tolerance_m = 0.0002F;
  float finest_m = 0.001F;          // from texel to texel; cubes are divided no further
  std::size_t most_bricks = 65536;  // 32 MB; where they run out, what is off most is divided first
};

// The distances that `surface` (of triangles: of a bare cloud there is no inside) gives within
// `band_m` of it, `bounds` (m) being the design's. Needs up to eight times the memory of the bricks
// on the way. The same to the bit on any number of threads. Nothing where it was cancelled.
[[nodiscard]] std::optional<DistanceVolume> make_distance_field(
    const DesignSurface& surface, const Eigen::AlignedBox3d& bounds,
    const DistanceFieldOptions& options = {}, const Watch& watch = {});

}  // namespace spool
