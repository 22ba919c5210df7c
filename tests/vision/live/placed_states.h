// States of the bracket whose deviations are measured at a pose that is simply said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "tests/app/runner/simulated_scene.h"
#include "vision/live/vision_state.h"
#include "vision/scan/noise_model.h"

namespace spool::test {

inline NoiseModel millimetre_noise() {
  NoiseModel noise;
  noise.constant_m = 0.001;  // what the frames are drawn with, rounding to millimetres besides
  return noise;
}

using ChangeFrame = std::function<void(DepthFrame&)>;

// Frame `index`, filmed from `T_true`, measured as if it had been filmed from `T_said`.
[[nodiscard]] VisionState placed_state(const Pose& T_true, const Pose& T_said, int index,
                                       const ChangeFrame& change = {});

// A camera that walks about the bracket, a degree and 15 mm a frame, always above it.
[[nodiscard]] Pose walking(int index);

}  // namespace spool::test
