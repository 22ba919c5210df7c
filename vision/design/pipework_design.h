// A design out of pipework: parts with bodies from the catalogue, joints, datums.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/core/result.h"
#include "vision/design/design_model.h"
#include "vision/piping/pipework.h"

namespace spool {

// Fills `design`, whose path is set, from a connected pipework: x = east, y = up, z = -north,
// metres, rebased as build_mesh() does. One part for each component with a body, named by kind and
// number in the file ("pipe-1", "elbow-2"); joints with their weld's number ("" where nothing is
// welded); as datum the first flange or blind whose face nothing is bolted to, of the widest.
// Problems of the file become warnings with their lines. kBadInput as build_mesh().
[[nodiscard]] Status design_of(const piping::Pipework& pipework, DesignModel& design);

// The names of the parts that design_of() gives, by component; "" for welds, bolts and supports.
[[nodiscard]] std::vector<std::string> part_names(const piping::Pipework& pipework);

}  // namespace spool
