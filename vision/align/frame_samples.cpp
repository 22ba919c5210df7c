// The readings of a frame that carry its pose: an even grid of them, with their noise.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/frame_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vision/core/median.h"

namespace spool {

FrameSamples sample_frame(const SeenFrame& frame, const ReadingNoise& noise, std::size_t most) {
  assert(frame.is_usable() && most > 0 && "an organised cloud with normals");
  const auto is_measured = [&](std::size_t i) {
    return frame.cloud.points[i].z() > 0 && !frame.cloud.normals[i].isZero();
  };
  std::size_t measured = 0;
  for (std::size_t i = 0; i < frame.cloud.size(); ++i) measured += is_measured(i) ? 1U : 0U;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(measured) /
                                                                    static_cast<double>(most)))));
  FrameSamples chosen;
  chosen.samples.reserve(measured / static_cast<std::size_t>(step * step) + 16);
  std::vector<float> variances;
  for (int v = step / 2; v < frame.camera.height; v += step)
    for (int u = step / 2; u < frame.camera.width; u += step) {
      const auto i = static_cast<std::size_t>(v * frame.camera.width + u);
      if (!is_measured(i)) continue;
      const Eigen::Vector3f& point = frame.cloud.points[i];
      const Eigen::Vector3f& normal = frame.cloud.normals[i];
      chosen.samples.push_back({point, normal, noise.variance(point, normal)});
      variances.push_back(chosen.samples.back().variance);
    }
  if (variances.empty()) return chosen;
  chosen.variance = double{median(variances)};
  chosen.correlated = correlated_readings(frame.camera, step);
  return chosen;
}

}  // namespace spool
