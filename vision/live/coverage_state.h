// What is known of the design's surface up to a frame, and where to look next.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/inspect/part_reading.h"
#include "vision/live/surface_patches.h"

namespace spool {

enum class PatchSight : std::uint8_t { kNotSeen, kPartly, kKnown };

// What the fitter may do for more of the spool to be known.
struct LookAdvice {
  std::string text;                       // one sentence; empty: nothing to say
  int part = -1;                          // that there is to be seen
  std::optional<Eigen::Vector3f> target;  // m, design frame: what to look at
};

struct CoverageState {
  std::shared_ptr<const SurfacePatches> patches;  // null: nothing is kept
  std::vector<PatchSight> sight;                  // one a patch
  std::vector<PartReading> parts;                 // in the design's order
  LookAdvice advice;
};

}  // namespace spool
