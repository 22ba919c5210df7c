// Which landmarks the picture that picks are made on has measured, as far as the picks tell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vision/align/three_point.h"
#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/design/landmarks.h"
#include "vision/inspector.h"

namespace spool {

struct PickScene {
  const PreparedDesign& design;
  const Camera& camera;
  const DepthFrame& frame;
  std::span<const Eigen::Vector3f> scan;  // the frame's points, camera frame (m)
  std::optional<Pose> T_design_camera;    // of an earlier alignment; may be wrong by now
};

// For each landmark 0 to 1: how likely the sensor measured something where it is. With nothing to
// go by, 1. An earlier pose counts where the frame agrees with it. Two pairs leave a turn about the
// line through them: the turn at which the frame agrees best with the design. One pair leaves the
// distance from it: nothing measured that far away, no landmark.
[[nodiscard]] std::vector<double> measured_likelihood(const PickScene& scene,
                                                      std::span<const Landmark> landmarks,
                                                      std::span<const PointPair> pairs);

}  // namespace spool
