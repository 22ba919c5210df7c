// One hand-held sequence of a spool as built, followed from the first frame's picks on: how far off
// the pose of the camera in the datum's frame was.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene.h"
#include "vision/core/result.h"
#include "vision/live/vision_state.h"

namespace spool::campaign {

struct LiveRow {
  std::string name;
  ObjectKind kind = ObjectKind::kSmallSpool;
  std::vector<Defect> defects = {};
  HandSettings hand = {};
  double seconds = 6;
  double bump_at_s = -1;  // from then on the object lies elsewhere: moved and turned by so much
  double bump_m = 0, bump_rad = 0;
};
[[nodiscard]] std::vector<LiveRow> live_rows();

struct LiveFrame {
  double seconds = 0;
  TrackQuality quality = TrackQuality::kLost;
  double off_m = 0, off_rad = 0;  // of the pose that is given, against the truth
  double u_m = 0, u_rad = 0;      // stated, two standard deviations
  // The two that make up the pose: the camera in the scene, and the design's middle there, the
  // scene being that of the first frame; meaningless once the map was begun anew.
  double camera_off_m = 0, camera_off_rad = 0, place_off_m = 0, place_off_rad = 0;
  bool was_moved = false;  // the spool, it says
  double wall_ms = 0;      // depth in to state out
  std::string hint = "";
};

// Every frame of the sequence, the first one aligned by picks that are a centimetre and a degree
// off. An error where the first frame does not show the object.
[[nodiscard]] Result<std::vector<LiveFrame>> run_live(const LiveRow& row, std::uint32_t seed);

}  // namespace spool::campaign
