// Which parts of a design lie in one line: what looks like one length of pipe.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/design/design_model.h"

namespace spool {

// m, design frame; the direction is a unit vector, or zero where there is no joint to tell it.
struct RunLine {
  Eigen::Vector3f point = Eigen::Vector3f::Zero(), direction = Eigen::Vector3f::Zero();
};

struct StraightRuns {
  std::vector<int> of_part;  // the run that most of a part's joints lie on; -1: as many on another
  int count = 0;
  std::vector<RunLine> lines;        // of each run
  std::vector<std::vector<int>> at;  // of each part, the runs that it has a joint on
};

// Runs are the lines of the parts' own joined ports; a part without a joint is a run by itself.
[[nodiscard]] StraightRuns straight_runs(const DesignModel& design);

}  // namespace spool
