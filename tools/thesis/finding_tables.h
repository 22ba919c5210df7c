// Tables 4-5 to 4-12 from scenes of our own, the printed numbers beside them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "vision/core/cancel.h"
#include "vision/core/result.h"
#include "vision/find/thesis_finder.h"

namespace spool::thesis {

struct FindingBench {
  std::uint32_t seed = 1;  // of the scenes and of the finder
  int effectiveness_scenes = 6;
  double success_limit_m = 0.1;  // m, any corner of the design's box; the thesis judged by eye
  ThesisFinderOptions finder;
};

// Table `name` ("4-5" to "4-12") as text to `out`. kUsage: there is no such table here.
[[nodiscard]] Status print_finding_table(const std::string& name, const FindingBench& bench,
                                         std::ostream& out, const Watch& watch);

}  // namespace spool::thesis
