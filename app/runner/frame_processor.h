// One frame in, one state out: thin, keep the alignment, measure. Synchronous.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "app/runner/vision_state.h"
#include "vision/align/icp.h"
#include "vision/core/camera.h"
#include "vision/core/result.h"
#include "vision/inspector.h"
#include "vision/scan/noise_model.h"

namespace spool {

struct FrameProcessorOptions {
  int stride_px = 2;                // every so many pixels in u and v are kept
  std::size_t track_points = 6000;  // at most this many points go into the pose
  double near_design_m = 0.10;      // m; points this near the design's box take part in the pose
  double max_deviation_m = 0.03;    // m; further from the surface: not the object
  double align_distance_m =
      0.05;  // m; a picked pair may be this far off (5-20 mm: ARCHITECTURE, Taps)
  double track_distance_m = 0.03;  // m; how far a surface may move from one frame to the next
  // Of the surface that should be seen, the share that must be for a pose to be good or to be
  // believed.
  double good_agreement = 0.7;
  double lost_agreement = 0.4;
  double good_rms_noises = 3.0;  // residuals over the sensor's noise for "good"
  // A frame's pose has to be good to its own noise, and to be there before the next frame is.
  int track_iterations = 20;
  double track_stop_m = 1e-4;    // m
  double track_stop_rad = 1e-4;  // rad
  // Coverage that is shown live is judged by so many samples a part: right to 4 % of the part.
  std::size_t coverage_samples = 150;
  double min_in_sight = 0.25;    // a hand may hide the rest
  std::size_t min_samples = 40;  // fewer surface samples in sight: cannot tell where it is
};

// Keeps the pose from frame to frame by refining the last one (a hand-held camera at 30 fps moves a
// few millimetres between frames). One thread at a time.
class FrameProcessor {
 public:
  FrameProcessor(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                 const NoiseModel& noise, const FrameProcessorOptions& options = {});
  ~FrameProcessor();
  FrameProcessor(FrameProcessor&&) noexcept;
  FrameProcessor& operator=(FrameProcessor&&) noexcept;

  // The state of the next frame. kBadInput where the frame's size is not the camera's.
  [[nodiscard]] Result<VisionStatePtr> process(std::shared_ptr<const DepthFrame> frame);

  // While picks are made on `held`, frames that follow are registered to it, so that the pose that
  // the picks give can be carried on to the frame then seen.
  void hold(VisionStatePtr held);
  void release();

  // Refines the guess on the held state's frame and gives that frame's new state; later frames go
  // on from it.
  [[nodiscard]] VisionStatePtr align(const VisionState& held, const Pose& T_design_camera);
  void forget();  // no alignment any more

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
