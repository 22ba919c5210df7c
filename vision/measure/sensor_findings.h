// What is said where a scan contradicts the calibration of the sensor that made it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/design/design_model.h"
#include "vision/inspect/inspection.h"

namespace spool {

// One finding of kind `scale` for each contradiction: pieces of known size, or planes that are
// bent.
[[nodiscard]] std::vector<Finding> sensor_findings(const DesignModel& design,
                                                   const Inspection& inspection);

// Why nothing may be ok because of them; empty where nothing contradicts the calibration.
[[nodiscard]] std::string sensor_doubt(const Inspection& inspection);

}  // namespace spool
