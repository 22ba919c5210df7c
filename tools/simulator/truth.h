// What a simulated scene really holds, as the side file that goes with its frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <nlohmann/json_fwd.hpp>

#include "tools/simulator/simulator.h"

namespace spool::simulator {

// {schema, design, T_map_design, parts[], joints[], frames[]}, the conventions of report.json
// (ARCHITECTURE, What inspect writes): a part's pose_error is inverse(nominal) * as built in its
// own frame seen from the datum, a joint's error that of b's port seen from a's port as built;
// translation (m) and rotation vector (rad).
[[nodiscard]] nlohmann::json truth_json(const Simulator& simulator, std::int64_t frames);

}  // namespace spool::simulator
