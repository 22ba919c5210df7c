// Where the design is in one picture of the camera, with no tap: the poses that the picture bears
// out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/cancel.h"
#include "vision/find/finder_model.h"
#include "vision/inspector.h"
#include "vision/live/vision_state.h"
#include "vision/scan/noise_model.h"

namespace spool {

struct FindAnswer {
  // The picture with the design fitted to it, best first: what may be aligned with. More than one:
  // the picture does not tell which is meant. None: not found.
  std::vector<VisionStatePtr> poses;
  std::string reason;  // not found: why, and what to do; one sentence
};

// Looks for the design in the picture's frame, every pixel of it; fits it at every pose that
// explains the frame as three picks would be fitted, and keeps the poses that the picture bears
// out: those that show steel where the design has it, not what lies behind. Poses that the design's
// own symmetry makes equal are one. Nothing is found by a cancelled search. Any thread.
[[nodiscard]] FindAnswer find_in_picture(const std::shared_ptr<const PreparedDesign>& design,
                                         const FinderModel& finder, const VisionState& picture,
                                         const Camera& camera, const NoiseModel& noise,
                                         const Watch& watch = {});

}  // namespace spool
