// Vertices that lie on one another become one.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace spool {

// For each vertex the place of the first one that lies within `tolerance` (m, over 0) of it, itself
// where there is none. Vertices are never chained: each is compared with kept ones only. Linear in
// time.
[[nodiscard]] std::vector<std::uint32_t> weld_vertices(std::span<const Eigen::Vector3f> vertices,
                                                       float tolerance);

// The tolerance (m) at which equal corners that went through different roundings meet: a few units
// in the last place of the largest coordinate, at least a micrometre.
[[nodiscard]] float welding_tolerance(std::span<const Eigen::Vector3f> vertices);

}  // namespace spool
