// Saves the last seconds of the sensor as a depth folder, with the poses that were told of them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "app/application/pose_table.h"
#include "app/sensor/frame_ring.h"
#include "vision/core/camera.h"
#include "vision/core/result.h"

namespace spool {

struct LastSeconds {
  Camera camera;
  std::vector<sensor::PackedDepthPtr> frames;  // oldest first
  PoseTable poses;                             // of frames by their place in `frames`

  [[nodiscard]] double seconds() const {
    return frames.empty() ? 0 : frames.back()->seconds - frames.front()->seconds;
  }
};

// Writes `out`/last_001, or the next number that is free: camera.json, depth/, times.csv and
// poses.csv. The folder appears whole under its name or not at all. Gives its path; kIo where it
// cannot be written, kUsage where there is no frame. Slow: a second or more. Any thread.
[[nodiscard]] Result<std::filesystem::path> save_last_seconds(const std::filesystem::path& out,
                                                              const LastSeconds& last);

}  // namespace spool
