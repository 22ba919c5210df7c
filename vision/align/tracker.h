// Follows the camera through the scene: frame to scan map, with what the pose is worth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vision/align/weak_directions.h"
#include "vision/core/pose.h"
#include "vision/core/result.h"
#include "vision/scan/scan_map.h"
#include "vision/scan/seen_frame.h"

namespace spool {

struct TrackerOptions {
  ScanMapOptions map = {};
  std::size_t samples = 7000;        // readings of a frame that go into the pose, at most about
  double good_m = 0.003;             // m; a pose marked good is within this …
  double good_rad = 0.00524;         // rad; … and this (0.3 degrees), at 95 %
  int confirmations = 3;             // frames that must bear out a pose that was found anew
  int searches_per_frame = 2;        // views tried for each frame while lost
  std::size_t most_keyframes = 200;  // of the map, whatever the length of the way
  int frames_a_loop = 10;            // of so many frames one is asked whether it closes a loop
  double most_gap_s = 0.5;           // s between frames that a hand's motion is still followed over
};

[[nodiscard]] std::optional<Error> validate(const TrackerOptions& options);

enum class PoseQuality {
  kGood,  // within good_m and good_rad
  kPoor,  // the best guess there is
  kLost   // the pose is the last one known and means nothing
};
[[nodiscard]] std::string_view name(PoseQuality quality);  // good, poor, lost

enum class LoopOutcome {
  kNone,      // no old piece of the map came into view
  kMeasured,  // one did; the next frame tells what becomes of it
  kClosed,    // the map was moved (map_motions), and this pose is in it as it is now
  kRefused    // it looks like an old place, but cannot be it by all that is known of the way
};

struct TrackedPose {
  // The map frame is the camera's of the first frame that started the map.
  Pose T_map_camera = Pose::Identity();
  // Of a small motion (translation, rotation) about the camera in the axes of the map, m and rad:
  // against the first frame's camera, what the way from there may have drifted by included.
  Matrix6d covariance = Matrix6d::Identity();
  // What the frame did not hold; there the pose is as predicted, and the covariance grows.
  std::vector<WeakDirection> weak_directions = {};
  PoseQuality quality = PoseQuality::kLost;
  // 0 to 1: of the readings that would see the camera displaced, the share that agree with the map,
  // for the displacement where that is least. Over half: the pose is borne out.
  double score = 0;
  std::string reason;        // why it is not good, for a screen; empty where it is
  bool found_again = false;  // by the stored views, in this frame
  LoopOutcome loop = LoopOutcome::kNone;
  // Of a closed loop: the motion of the map's pieces by MapCell::keyframe, in the map frame.
  std::vector<Pose> map_motions = {};
  Pose T_current_moved = Pose::Identity();      // of them that of the piece that the camera is in
  FuseReport fused = {};                        // zero where the frame was not taken into the map
  std::map<std::string, double> timing_s = {};  // close, fit, fuse
};

// The scene carries the pose, not the design, so that a wrong spool cannot bend it (KinectFusion,
// Newcombe et al. 2011, with surfels for the volume). Frames that do not fit well leave the map
// alone. The pieces of the map hang on keyframes of a pose graph: coming back to old ones closes
// the loop (vision/align/loop_closure) and moves the map. Deterministic on any number of threads;
// use from one thread at a time.
class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options = {});
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  // The pose of the next frame. A frame that is not usable, that shows nothing or whose clock went
  // back has a stated quality like any other.
  [[nodiscard]] TrackedPose track(const SeenFrame& frame);

  // The frame that was tracked last has this pose, with this covariance (as in TrackedPose), known
  // by more than the scene: what the scene does not hold goes on from there. A frame that was lost
  // is looked for from there next.
  void tell(const SeenFrame& frame, const Pose& T_map_camera, const Matrix6d& covariance);

  [[nodiscard]] const ScanMap& map() const;
  // Forgets the scene: the next frame that is fit for it starts a new map.
  void clear();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
