// A scene with its design as a file gives it, prepared to be found, and how far off a pose is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tools/campaign/scene.h"
#include "vision/core/result.h"
#include "vision/inspector.h"

namespace spool::campaign {

struct FindTrial {
  Scene scene;
  std::shared_ptr<const PreparedDesign> design;
  double noise_m = 0;  // of the scene's points, as it is told from them
};
// The design is written and read again.
[[nodiscard]] Result<FindTrial> make_find_trial(Scene scene);

// How far off a found pose is, modulo the design's own symmetry and for the nearest object.
struct Miss {
  double mean_m =
      1e9;  // displacement of the design's own points; huge where no object stands there
  double angle_rad = 4;
};
// `T_design_scan`: between the files' frames.
[[nodiscard]] Miss miss_of(const FindTrial& trial, const Pose& T_design_scan);

}  // namespace spool::campaign
