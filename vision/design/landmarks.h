// Points of a design that a fitter can find again on the steel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"
#include "vision/design/design_surface.h"

namespace spool {

struct Landmark {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m, design frame, on the surface
  std::int32_t part = -1;
  std::string text;  // "flange F1, rim"
};

struct LandmarkProposal {
  std::vector<Landmark>
      landmarks;  // in the order they are best picked; the first three are never in line
  // The direction (unit, design frame) of a look at the design that shows them.
  Eigen::Vector3d look = -Eigen::Vector3d::UnitZ();
};

// Up to `count` landmarks: outermost points of parts, on the surface and free of other parts, the
// first three as far apart and as little in line as the design allows, the rest filling the gaps. A
// port's centre would be better known but lies in the air of an open pipe, where neither finger nor
// camera finds it. Fewer than three only where the design has no three points off a line.
[[nodiscard]] LandmarkProposal propose_landmarks(const DesignModel& design,
                                                 const DesignSurface& surface,
                                                 std::size_t count = 6);

}  // namespace spool
