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
  std::vector<std::size_t> others;  // into the poses: explain the scan about as well, best first
};

// `poses`: best explained first; if any is believed, it is the first. Of a spool that is not built
// as designed that is the pose of its largest piece (vision/inspect/datum_side goes on from there).
[[nodiscard]] FindDecision decide(const FinderModel& model, const std::vector<PoseEvidence>& poses);

}  // namespace spool
