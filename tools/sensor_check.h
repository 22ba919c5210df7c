// spoolsight-inspect --sensor-check: a view of a flat floor or wall in, sensor.json out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/inspect_options.h"
#include "vision/core/result.h"

namespace spool::tools {

// Writes DIR/sensor.json and prints the verdict; 0 where it was written, whatever it says.
[[nodiscard]] Result<int> run_sensor_check(const InspectOptions& options,
                                           const std::string& created);

}  // namespace spool::tools
