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

#include "vision/live/surface_patches.h"

namespace spool {

// Of one part, over the frames of late.
struct PartReading {
  bool is_seen = false;  // any of it; else the rest means nothing
  double mean_m = 0;     // mean signed deviation of its surface that was seen, + outside the design
  double u_m = 0;        // of the mean: two standard deviations, the doubt of the pose in it
  double coverage = 0;   // share of its surface that is known well enough for a number, 0 to 1
};

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
