// A spool of rods with joints, built right or wrong: what the chain of joints is tested on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>
#include <vector>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/design/design_surface.h"
#include "vision/design/sampling.h"
#include "vision/inspect/explanation.h"

namespace spool::test {

// The parts. A riser (the datum) with a foot, an arm on its top with an upright tip at its end, and
// a side branch half way up with a short end that hangs down.
enum JointedPart { kRiser, kFoot, kArm, kTip, kSide, kEnd };

struct JointedSpool {
  std::vector<Rod> rods;
  DesignModel design;
  DesignSurface surface;
  SurfaceSamples samples;

  JointedSpool();
  [[nodiscard]] ExplainedDesign explained() const { return {design, surface, samples}; }
  // About `per_m2` points a square metre of the rods that are kept, each where `T_design_built` of
  // its part puts it, noise 1 mm.
  [[nodiscard]] PointCloud scan(const std::vector<Pose>& T_design_built,
                                const std::vector<bool>& is_there, std::uint32_t seed = 1) const;
  [[nodiscard]] std::vector<Pose> as_designed() const;
};

// The one that all tests share.
[[nodiscard]] const JointedSpool& jointed();

// Turned about the line by degrees, and moved.
[[nodiscard]] Pose turned_about(const Eigen::Vector3d& point, const Eigen::Vector3d& axis,
                                double degrees);
[[nodiscard]] Pose moved(const Eigen::Vector3d& by);

}  // namespace spool::test
