// Flange, pipe, elbow, pipe, flange: a spool with a drawing, scanned as drawn or as built.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/measure/dimensions.h"

namespace spool::test {

enum SpoolPart { kFlangeA, kPipe1, kElbow, kPipe2, kFlangeB, kSpoolParts };

// NPS 4. Flange A's face looks down at z = -0.03, pipe_1 stands on it to z = 0.5, the elbow's
// centre is at z = 0.65, pipe_2 goes from there to x = 0.65 and flange B's face looks along x at
// 0.68. The elbow has ports and no surface.
[[nodiscard]] DesignModel two_flange_spool();

struct SpoolScan {
  double noise_m = 0.0005;
  std::vector<Pose> T_design_built = std::vector<Pose>(kSpoolParts, Pose::Identity());
  std::vector<bool> is_there = std::vector<bool>(kSpoolParts, true);
  double pipe_2_radius_m = 0.05715;
  double scale = 1;
  double per_square_metre = 40000;  // points: 5 mm apart
};

// The spool from all sides.
[[nodiscard]] PointCloud scan_of_spool(const SpoolScan& built, std::uint32_t seed = 1);

// Fits features to a scan in the design frame, all of it within 20 mm of the design.
[[nodiscard]] PartFeatures features_of(const DesignModel& design, const PointCloud& scan,
                                       double warp_u_m = 0,
                                       const std::optional<Eigen::Vector3d>& eye = std::nullopt);

// Scans the spool and fits its features.
[[nodiscard]] PartFeatures features_of(const DesignModel& design, const SpoolScan& built,
                                       std::uint32_t seed = 1, double warp_u_m = 0);

}  // namespace spool::test
