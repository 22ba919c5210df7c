// The readings of a frame that carry its pose: an even grid of them, with their noise.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vision/scan/reading_noise.h"
#include "vision/scan/seen_frame.h"

namespace spool {

struct FrameSample {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m, camera frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, camera frame
  float variance = 0;                                // m^2, along the normal
};

struct FrameSamples {
  std::vector<FrameSample> samples = {};
  double variance = 0;    // m^2, the samples' median: what unit weight stands for
  double correlated = 1;  // how many samples share one correlation window of the sensor
};

// Readings with a normal, at most about `most`, on a square grid of pixels. `frame` must be usable.
[[nodiscard]] FrameSamples sample_frame(const SeenFrame& frame, const ReadingNoise& noise,
                                        std::size_t most);

}  // namespace spool
