// Cases for finding: the campaign's scenes, thinned as the other libraries' own examples thin them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/campaign/scene.h"
#include "tools/compare/contender.h"
#include "vision/core/result.h"

namespace spool::compare {

struct FindRow {
  std::string name;
  campaign::SceneRequest request;
};

// Spool and frame among little and much clutter, few points, half of it, and without the object.
[[nodiscard]] std::vector<FindRow> find_rows();

// A scene with its design prepared for our finder and sampled for the others.
struct FindScene {
  campaign::Scene scene;
  std::shared_ptr<const PreparedDesign> design;
  FindCase points;  // for the others: scan and design, thinned to the same spacing, with normals
};
[[nodiscard]] Result<FindScene> make_find_scene(const campaign::SceneRequest& request);

// Displacement (m) of the design's points that the pose is off by, modulo the design's own symmetry
// and for the nearest object: the mean of them. Huge where no object stands there.
[[nodiscard]] double mean_miss(const FindScene& of, const Pose& T_design_scan);

}  // namespace spool::compare
