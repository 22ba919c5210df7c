// Cases for refinement: a spool scanned among clutter, its design, and a guess that is off.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "tools/compare/contender.h"
#include "vision/core/result.h"

namespace spool::compare {

struct IcpCaseRequest {
  std::size_t source_points = 20'000;
  std::size_t target_points = 80'000;
  double clutter_within_m = 0.1;  // of the object: what lies further away is cut off
  double station_error_m = 0;     // what no registration of the whole can undo
  double off_rad = 0.0523598776;  // 3 degrees, about the design's centre
  double off_m = 0.03;
  std::uint32_t seed = 1;
};

[[nodiscard]] Result<IcpCase> make_icp_case(const IcpCaseRequest& request);

// Displacement (m) that an error of the pose gives the target's points: the mean of them.
[[nodiscard]] double mean_displacement(const IcpCase& of, const Pose& T_design_scan);

}  // namespace spool::compare
