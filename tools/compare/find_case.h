// Cases for finding: the campaign's scenes, thinned as the other libraries' own examples thin them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/campaign/find_rows.h"
#include "tools/campaign/find_trial.h"
#include "tools/compare/contender.h"
#include "vision/core/result.h"

namespace spool::compare {

// Of the campaign's rows spool and frame among little and much clutter, few points, half of it, and
// without the object: the others take minutes for some.
[[nodiscard]] std::vector<campaign::FindRow> compared_rows();

// A scene with its design prepared for our finder and sampled for the others.
struct ComparedTrial {
  campaign::FindTrial trial;
  FindCase points;  // for the others: scan and design, thinned to the same spacing, with normals
};
[[nodiscard]] Result<ComparedTrial> make_compared_trial(const campaign::SceneRequest& request);

// Mean displacement (m) of the design's points by a pose between the rebased frames.
[[nodiscard]] double mean_miss(const ComparedTrial& of, const Pose& T_design_scan);

}  // namespace spool::compare
