// Which parts of a design lie in one line: what looks like one length of pipe.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/design/design_model.h"

namespace spool {

struct StraightRuns {
  std::vector<int> of_part;  // the run that most of a part's joints lie on; -1: as many on another
  int count = 0;
};

// Runs are the lines of the parts' own joined ports; a part without a joint is a run by itself.
[[nodiscard]] StraightRuns straight_runs(const DesignModel& design);

}  // namespace spool
