// The scan as the chain of joints looks at it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace spool {

struct ChainOptions {
  double noise_m = 0.003;       // m; standard deviation of a point
  double size_m = 1;            // m; the design's diagonal
  double least_move_m = 0.020;  // m; of less it is for features to tell
  std::size_t most_pieces = 4;

  // So near (m) a point lies on a surface.
  [[nodiscard]] double gate_m() const { return std::max(3.5 * noise_m, 0.001 * size_m); }
};

// m, design frame.
struct ChainScan {
  std::span<const Eigen::Vector3f> explained;    // points on the design…
  std::span<const std::int32_t> explained_part;  // …and the part each lies on; -1: on a moved piece
  std::span<const std::uint8_t> is_well;  // …within the gate, not only near it; empty: all of them
  std::span<const Eigen::Vector3f> left;  // what is neither that nor floor nor wall
};

}  // namespace spool
