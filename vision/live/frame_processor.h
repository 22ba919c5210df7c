// One frame in, one state out: thin, follow the camera, place the design, measure. Synchronous.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "vision/align/tracker.h"
#include "vision/core/camera.h"
#include "vision/core/result.h"
#include "vision/inspector.h"
#include "vision/live/live_alignment.h"
#include "vision/live/vision_state.h"
#include "vision/scan/noise_model.h"

namespace spool {

struct FrameProcessorOptions {
  int stride_px = 2;              // every so many pixels in u and v are kept
  double max_deviation_m = 0.03;  // m; further from the surface: not the object
  LiveAlignmentOptions alignment = {};
  TrackerOptions tracker = {};
};

// The whole scene carries the camera from frame to frame (Tracker), and the design's place in the
// scene is kept beside it (LiveAlignment). One thread at a time.
class FrameProcessor {
 public:
  FrameProcessor(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                 const NoiseModel& noise, const FrameProcessorOptions& options = {});
  ~FrameProcessor();
  FrameProcessor(FrameProcessor&&) noexcept;
  FrameProcessor& operator=(FrameProcessor&&) noexcept;

  // The state of the next frame. kBadInput where the frame's size is not the camera's.
  [[nodiscard]] Result<VisionStatePtr> process(std::shared_ptr<const DepthFrame> frame);

  // Refines the guess on the held state's frame and gives that frame's new state. However long ago
  // that was: the camera was followed meanwhile.
  [[nodiscard]] VisionStatePtr align(const VisionState& held, const Pose& T_design_camera);
  void forget();  // no alignment any more

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
