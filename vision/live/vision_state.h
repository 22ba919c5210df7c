// What vision saw in one frame: what is shown together belongs to one of these.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "vision/align/tracker.h"
#include "vision/core/depth_frame.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/inspect/deviation.h"
#include "vision/live/coverage_state.h"

namespace spool {

enum class TrackQuality {
  kUnaligned,
  kGood,
  kPoor,
  kPaused,  // the picture went out for a moment: the pose is the last one, and not of this frame
  kLost
};
// As poses.csv spells it: good, poor (a paused one too) or lost (a frame before the alignment has
// no pose: lost).
[[nodiscard]] std::string_view name(TrackQuality quality);

// Immutable once published; shared between threads by shared_ptr<const VisionState>.
struct VisionState {
  std::uint64_t revision = 0;   // counts published states
  std::uint64_t alignment = 0;  // counts alignments asked for and answered up to this state
  std::shared_ptr<const DepthFrame> frame;
  PointCloud scan;    // the frame thinned: measured points with normals, camera frame (m)
  int stride_px = 1;  // every so many pixels of the frame are in it
  TrackQuality quality = TrackQuality::kUnaligned;
  bool is_out = false;  // the picture went out (DropoutWatch): nothing is told of this frame
  std::string hint;     // what to do where quality is not good; one sentence
  // The camera in the scene; means something unless `camera` is kLost. The map's frame is another
  // one after the map was begun anew: `map` counts them.
  PoseQuality camera = PoseQuality::kLost;
  Pose T_map_camera = Pose::Identity();
  Matrix6d camera_covariance = Matrix6d::Identity();  // of it: TrackedPose
  std::uint64_t map = 0;
  std::size_t map_cells = 0;  // that it holds
  // Design coordinates without the design's origin. Of a lost frame: the last pose that was
  // believed.
  Pose T_design_camera = Pose::Identity();
  double pose_u_m = 0, pose_u_rad = 0;  // of it, at the camera: two standard deviations
  // A loop was closed in this frame and moved the design by so much for the camera: drift that was
  // taken out of the map.
  double loop_moved_m = 0, loop_moved_rad = 0;
  bool was_moved = false;  // the spool; the pose is the one that it has now
  bool is_gone = false;    // it is not where it was, and has to be looked for everywhere
  // The rest is empty unless quality is good or poor. One entry a point of `scan`.
  PointCloud scan_design;
  std::vector<PointClass> classes;
  Deviations deviations;
  CoverageState coverage;    // of the frames up to this one
  double rms_m = 0;          // of the tracked correspondences: scan quality, never a verdict
  double agreement = 0;      // of the surface that should be seen, the share that is (0 to 1)
  double point_noise_m = 0;  // the sensor's own standard deviation at the spool's distance
  // Seconds of each stage; of those of following the camera (`follow`) also its own: `follow/fit`.
  std::map<std::string, double> timing_s;

  [[nodiscard]] bool is_tracked() const {
    return quality == TrackQuality::kGood || quality == TrackQuality::kPoor;
  }
};

using VisionStatePtr = std::shared_ptr<const VisionState>;

}  // namespace spool
