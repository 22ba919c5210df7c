// Keeps what is known of the design's surface from frame to frame, and says where to look next.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "vision/inspector.h"
#include "vision/live/look_advice.h"
#include "vision/live/next_view.h"
#include "vision/live/patch_readings.h"

namespace spool {

// One thread at a time.
class Coverage {
 public:
  // `seen_by`: the camera of the thinned pictures that the points come from.
  Coverage(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
           const Camera& seen_by, const NoiseModel& noise);

  void clear();  // the spool was aligned anew, or moved
  // A placed state whose deviations are measured, with the covariance of its pose at the design
  // origin.
  void add(const VisionState& state, const Matrix6d& covariance);
  void follow(const Pose& T_new_old) { readings_.follow(T_new_old); }  // see PatchReadings
  // Fills in what is known up to this state.
  void tell(VisionState& state, const Matrix6d& covariance);

 private:
  std::shared_ptr<const PreparedDesign> design_;
  std::shared_ptr<const SurfacePatches> patches_;
  PatchReadings readings_;
  NextView next_;
  LookAdviser adviser_;
};

}  // namespace spool
