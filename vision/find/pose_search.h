// Poses that may be right: pairs of scan elements laid on pairs of the design, tried on the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/cancel.h"
#include "vision/find/elements.h"
#include "vision/find/occupancy.h"
#include "vision/find/pair_table.h"

namespace spool {

struct PoseHypothesis {
  Eigen::Isometry3f T_design_scan = Eigen::Isometry3f::Identity();
  float score = 0;          // share of the design's samples with a scan point near
  std::uint32_t chunk = 0;  // of pairs it came from: others are independent of it
};

struct PoseSearchOptions {
  std::size_t pairs = 512;   // of the scan's elements, drawn at random
  std::size_t keep = 4;      // best hypotheses of each chunk of 32 pairs
  float least_score = 0.2F;  // what scores less is not kept
  std::uint64_t seed = 1;    // the same seed, the same hypotheses on any number of threads
};

// `samples`: design points (m) in random order, as many as a full score looks at. Best first.
[[nodiscard]] std::vector<PoseHypothesis> search_poses(const PairTable& table,
                                                       std::span<const Element> scan,
                                                       const Occupancy& occupancy,
                                                       std::span<const Eigen::Vector3f> samples,
                                                       const PoseSearchOptions& options,
                                                       const Watch& watch = {});

// The share of `samples` (design frame) that have a scan point near at the pose.
[[nodiscard]] float pose_score(const Eigen::Isometry3f& T_design_scan, const Occupancy& occupancy,
                               std::span<const Eigen::Vector3f> samples);

}  // namespace spool
