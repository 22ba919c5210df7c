// A straight bar that grows out of the spool: where it points, and where it ends.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "vision/design/design_surface.h"

namespace spool {

struct SteelBar {
  Eigen::Vector3f joined = Eigen::Vector3f::Zero();      // m; on its line, at the spool
  Eigen::Vector3f direction = Eigen::Vector3f::UnitZ();  // unit, away from the spool
  float length_m = 0;
  int part = -1;  // of the design, that its line goes into

  [[nodiscard]] float along(const Eigen::Vector3f& p) const { return (p - joined).dot(direction); }
};

// The bar that the points (m, design frame) are, whichever sides of it were seen: its line is what
// their normals have in common, it is round and longer than thick, and its line goes on into the
// steel of the design. Nothing where they are no such bar: a heap, a plate, a pipe that lies
// against the spool.
[[nodiscard]] std::optional<SteelBar> bar_out_of(const DesignSurface& surface,
                                                 std::span<const Eigen::Vector3f> points);

}  // namespace spool
