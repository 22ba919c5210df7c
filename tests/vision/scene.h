// A simulated scene of the shared data with its truth, and picks on it that are off as a tap is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "vision/inspector.h"

namespace spool::test {

struct Scene {
  std::shared_ptr<const PreparedDesign> design;
  PointCloud cloud;
  Pose T_design_scan = Pose::Identity();  // the inverse of truth's `pose`
  std::vector<std::uint16_t> labels;      // of each point: component, or 1000 and up
  std::vector<bool> undisturbed;          // of each component: lies where the design has it
};

// Fails the running test where a file cannot be read. `to_be_found`: the design is prepared for it.
[[nodiscard]] Scene load_scene(const std::filesystem::path& folder, bool to_be_found = false);

// Three places on the design's surface, far from each other and from one line, each pick on the
// scan off by `error_m` in a random direction.
[[nodiscard]] std::vector<PointPair> picks_on(const SurfaceSamples& samples,
                                              const Pose& T_design_scan, double error_m,
                                              std::mt19937& random);

// How far (m) the found pose puts the design's samples off, the worst of them, and the angle (rad).
struct PoseError {
  double worst_m = 0;
  double mean_m = 0;
  double angle_rad = 0;
};
[[nodiscard]] PoseError pose_error(const SurfaceSamples& samples, const Pose& T_found,
                                   const Pose& T_true);

}  // namespace spool::test
