// A design as it was built: where each part really is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/simulator/scene.h"
#include "vision/design/design_model.h"

namespace spool::simulator {

struct BuiltPart {
  Pose T_design_part = Pose::Identity();  // as built
  double length_m = 0;                    // longer than drawn by this
  std::size_t far_port = 1;               // the port that a longer part moves out
  bool missing = false;
};

struct AsBuilt {
  std::vector<BuiltPart> parts;  // of each DesignModel::parts
  TriangleMesh mesh;             // design frame, missing parts left out
  std::vector<std::int32_t> triangle_part;
};

// Applies `changes` in their order. A change moves the part and, with `followers`, all parts that
// hang on it seen from the datum (the first of design.datums, else the first part): along the
// joints where there are any, else in assembly order. kBadInput, naming `file`, for an unknown part
// or port, and for a length of what has no two ports.
[[nodiscard]] Result<AsBuilt> build_as(const DesignModel& design,
                                       const std::vector<AsBuiltChange>& changes,
                                       const std::string& file);

}  // namespace spool::simulator
