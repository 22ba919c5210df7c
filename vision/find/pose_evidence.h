// What speaks for a pose: the scan points it explains, and how much of the design they vouch for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"
#include "vision/find/find_scene.h"
#include "vision/find/finder_model.h"
#include "vision/scan/sight.h"

namespace spool {

struct PoseEvidence {
  Pose T_design_scan = Pose::Identity();
  std::size_t explained = 0;  // points of the thinned scan on the design's surface
  double chance = 0;          // of those, as many as the clutter round the design would put there
  double coverage = 0;        // share of the design's surface that they vouch for
  double scale_m = 0;         // standard deviation of their distances (1.4826 median)
  int free_motions = 0;       // motions of the design that they do not hold, chance taken off
  int hits = 0;               // independent draws that ended here
  std::vector<std::uint32_t> per_part;   // explained points on each part of the design
  std::vector<std::uint8_t> shows_stop;  // of each part: what a pipe through there would not have
  std::vector<std::uint32_t> points;     // the explained points' places in the scene, ascending
  Sighted sighted;  // of the surface that would face the camera; nothing where that is not known

  double behind = 0;  // share of the design's surface behind floor or walls that end the scan

  // Points that would not be where they are if this were wrong, less as many as would be there if
  // this were right where the camera saw through it and where nobody can have seen it.
  [[nodiscard]] double excess() const {
    return (static_cast<double>(explained) - chance) * sighted.share_there() * (1 - behind);
  }
};

// `gate_m`: within this of the surface a point is explained.
[[nodiscard]] PoseEvidence weigh_pose(const FinderModel& model, const FindScene& scene,
                                      const Eigen::Isometry3f& T_design_scan, double gate_m);

}  // namespace spool
