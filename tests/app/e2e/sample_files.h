// The sample that the program comes with, and the truth that its simulation wrote beside it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/depth_frame.h"
#include "vision/inspector.h"

namespace spool::test {

struct SampleFiles {
  std::filesystem::path design, recording, taps;
  std::shared_ptr<const PreparedDesign> prepared;
  Camera camera;
  std::vector<std::shared_ptr<const DepthFrame>> frames;
  std::vector<Pose> T_design_camera;  // of every frame, in the design file's own coordinates
};

// Nothing prepared where something could not be read.
[[nodiscard]] SampleFiles read_sample();

}  // namespace spool::test
