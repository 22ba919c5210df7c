// One hand-held sequence of known truth, tracked: how far off each frame's pose was.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene.h"
#include "vision/align/tracker.h"

namespace spool::campaign {

struct TrackRow {
  std::string name;
  ObjectKind kind = ObjectKind::kSmallSpool;
  HandSettings hand = {};
  double seconds = 8;  // 0: the whole way once
  double fps = 30;
  double covered_from_s = -1, covered_to_s = -1;  // nothing is measured between; the hand moves on
  double jump_at_s = -1;                          // from then on the hand is where it was …
  double jump_back_s = 0;                         // … so much earlier
  bool hook = false;                              // a block swings through the view
  bool parked = false;                            // the camera stands on a tripod
  int pixel_step = 2;                             // of 640 by 480
};
[[nodiscard]] std::vector<TrackRow> track_rows();

struct TrackedFrame {
  double seconds = 0;
  PoseQuality quality = PoseQuality::kLost;
  double off_m = 0,
         off_rad = 0;  // of the camera's pose in the scene, the first frame's being right
  double sigma_m = 0, sigma_rad = 0;  // stated, one axis
  double score = 0;
  std::string reason = "";  // why it is not good
  bool is_covered = false;
  double fit_ms = 0, fuse_ms = 0, prepare_ms = 0;
  std::size_t cells = 0;
};

struct TrackRun {
  std::vector<TrackedFrame> frames = {};
  double period_s = 0;  // of the way
};
// `most_frames` over 0 cuts the sequence short.
[[nodiscard]] TrackRun run_track(const TrackRow& row, std::uint32_t seed, int most_frames);

}  // namespace spool::campaign
