// Which of several designs lies in the scan, and what the scan says of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/inspect_options.h"
#include "vision/core/cancel.h"
#include "vision/inspector.h"

namespace spool::tools {

struct InspectedDesign {
  std::shared_ptr<const PreparedDesign> design;
  Inspection inspection;
  double read_s = 0;                  // reading and preparing the designs
  std::vector<std::string> warnings;  // one sentence each
};

// Reads each --design, inspects the scan against it, and gives the one that is found and explains
// the most points; the first where none is found. Where another explains nearly as many, a warning
// names it.
[[nodiscard]] Result<InspectedDesign> inspect_designs(const InspectOptions& options,
                                                      const InspectorOptions& settings,
                                                      const PointCloud& scan,
                                                      const NoiseModel& noise,
                                                      bool scan_unit_inferred, const Watch& watch);

}  // namespace spool::tools
