// From where an overlay is drawn so that a few pictures together show every part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/evidence/inspection_record.h"

namespace spool::evidence {

struct ViewChoice {
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // unit, into the picture, design frame
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();          // unit, upwards in the picture
  std::string text;                                       // "seen from +x -y +z", the design's axes
};

// Greedy cover (Johnson 1974): of 26 directions round the design, and the sensor's own of a depth
// frame, the one that shows most parts not shown yet, until all are that can be. A part is shown
// where at least half as much of its evidence faces the picture unhidden as in the direction best
// for it; evidence is its measured points, or the design's surface where there are too few. Steel
// that contradicts the design counts as parts of its own. Two views at least, six at most.
[[nodiscard]] std::vector<ViewChoice> choose_views(const InspectionRecord& record, double aspect);

}  // namespace spool::evidence
