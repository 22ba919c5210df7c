// From poses that were weighed to what may be said: found, found in several ways, or not found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/find/finder_model.h"
#include "vision/find/pose_evidence.h"

namespace spool {

struct FindDecision {
  bool found = false;
  std::string reason;               // not found: one sentence why, and what to do
  std::size_t best = 0;             // into the poses
  std::vector<std::size_t> others;  // that explain the scan about as well, best first
};

// `poses`: best explained first. Where several each explain another piece of the scan (the spool is
// not as designed between them), the one is meant that takes the fewest joints to be wrong, and
// among those the one that holds the datum.
[[nodiscard]] FindDecision decide(const FinderModel& model, const std::vector<PoseEvidence>& poses);

}  // namespace spool
