// What may be said of parts and of the whole, and why not more.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"

namespace spool {

struct JudgeOptions {
  double min_coverage =
      0.15;  // share of a part's visible surface; a pipe seen from one side shows half
  std::size_t min_points = 30;  // a cylinder has five unknowns; fewer points cannot carry it
  bool units_confirmed = true;
  bool single_frame = false;
};

// One entry a part in the design's order. Tolerances are judged on fitted features only
// (vision/measure), and none are fitted here: a part that was seen is suspicious, one that was not
// is not_measured.
[[nodiscard]] std::vector<PartFinding> judge_parts(const DesignModel& design,
                                                   const std::vector<PartDeviation>& deviations,
                                                   const Alignment& alignment,
                                                   const JudgeOptions& options = {});

// What stands beside the parts: a unit that was guessed, poses that explain the scan as well.
[[nodiscard]] std::vector<Finding> collect_findings(const Alignment& alignment,
                                                    const JudgeOptions& options = {});

// The worst of parts and dimensions in the order of worse(), and one sentence why.
void judge_whole(Inspection& inspection, const JudgeOptions& options = {});

}  // namespace spool
