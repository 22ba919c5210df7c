// The rows of the finding campaign: what varies from scene to scene, and what is held.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/campaign/scene.h"

namespace spool::campaign {

struct FindRow {
  std::string name;
  SceneRequest request;
};

// What the thesis varied in chapter 4, what it could not do (half a spool, an empty scene, a spool
// built wrong), designs drawn at random and a sensor held by hand.
[[nodiscard]] std::vector<FindRow> find_rows();

}  // namespace spool::campaign
