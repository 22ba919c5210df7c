// Where a design is in a scan, with no hint: found, found more than once, or not found.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/find/finder_model.h"
#include "vision/find/pose_evidence.h"

namespace spool {

struct FindOptions {
  double noise_m = 0.003;  // m; standard deviation of a scan point, as far as it is known
  std::uint64_t seed = 1;
  // Of a scan that is one depth image in the camera's frame: what it saw through is not there.
  const Sight* sight = nullptr;
};

struct FindResult {
  bool found = false;
  std::string reason;                // not found: why, and what to do; one sentence
  PoseEvidence best;                 // also where it is not believed
  std::vector<PoseEvidence> others;  // that explain the scan about as well, best first
  std::vector<PoseEvidence> tried;   // all that were looked at closely, best first
  std::size_t scan_points = 0;       // finite ones
  std::size_t thinned_to = 0;        // points that were looked at, off floor and walls
  bool was_thinned = false;          // the scan has so many points that not each was looked at
  int planes = 0;                    // floor, walls, tables set aside
  int rounds = 0;

  [[nodiscard]] bool is_ambiguous() const { return !others.empty(); }
};

// Draws pairs of scan elements, lays them on like pairs of the design, refines what fits and stops
// when the statistics say so: a believed pose that independent draws agree on, or so many draws
// that a design in the scan would have been met. No parameter for the user. `scan`: m, scan frame;
// NaN allowed. The same seed gives the same answer on any number of threads. A cancelled run is not
// found.
[[nodiscard]] FindResult find_design(const FinderModel& model,
                                     std::span<const Eigen::Vector3f> scan,
                                     const FindOptions& options = {}, const Watch& watch = {});

}  // namespace spool
