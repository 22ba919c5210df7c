// The hand-held sequences that the tracker is measured on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/track_trial.h"

namespace spool::campaign {

std::vector<TrackRow> track_rows() {
  const HandSettings brisk{};  // 0.3 m/s and 30 degrees a second
  HandSettings calm;
  calm.speed_m_s = 0.1;
  calm.turn_rad_s = 0.17;
  HandSettings along;
  along.way = Way::kAlong;
  along.speed_m_s = 0.25;
  HandSettings around = along;
  around.way = Way::kAround;
  HandSettings still;
  still.tremor_m = 0;
  still.tremor_rad = 0;
  std::vector<TrackRow> rows;
  rows.push_back({.name = "calm small", .hand = calm});
  rows.push_back({.name = "brisk small", .hand = brisk});
  rows.push_back({.name = "brisk random", .kind = ObjectKind::kRandomSpool, .hand = brisk});
  rows.push_back({.name = "brisk 3 m", .kind = ObjectKind::kPipeSpool3m, .hand = brisk});
  rows.push_back(
      {.name = "walk 3 m", .kind = ObjectKind::kPipeSpool3m, .hand = along, .seconds = 0});
  rows.push_back(
      {.name = "round 3 m", .kind = ObjectKind::kPipeSpool3m, .hand = around, .seconds = 0});
  rows.push_back(
      {.name = "covered", .hand = brisk, .seconds = 7, .covered_from_s = 4, .covered_to_s = 5});
  rows.push_back({.name = "jump", .hand = brisk, .seconds = 7, .jump_at_s = 5, .jump_back_s = 3.5});
  rows.push_back({.name = "hook", .hand = brisk, .hook = true});
  rows.push_back({.name = "5 fps", .hand = calm, .fps = 5});
  rows.push_back({.name = "90 fps", .hand = brisk, .seconds = 3, .fps = 90});
  rows.push_back({.name = "320x240 camera", .hand = brisk, .seconds = 5, .pixel_step = 4});
  rows.push_back({.name = "parked", .hand = still, .seconds = 60, .parked = true});
  return rows;
}

}  // namespace spool::campaign
