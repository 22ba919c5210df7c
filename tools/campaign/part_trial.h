// One hand-held look at a spool of which one part stands a little off: how far from the truth each
// part's mean deviation was.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene.h"
#include "vision/core/result.h"

namespace spool::campaign {

struct PartRow {
  std::string name;
  ObjectKind kind = ObjectKind::kSmallSpool;
  HandSettings hand = {};
  double seconds = 3;
  // The part that is off: moved by so much in a random direction, turned by so much about its
  // middle.
  double off_m = 0.003, off_rad = 0.004;
};
[[nodiscard]] std::vector<PartRow> part_rows();

struct TriedPart {
  std::string name;
  bool is_off = false;  // the one that was moved
  // The truth: the mean, over cells of a centimetre of its surface that any frame saw, of how far
  // along the design's normal the surface is displaced, by the patches' own equations.
  double truth_m = 0;
  double mean_m = 0, u_m = 0, coverage = 0;  // what was stated
};

// The parts that were given a number after so many seconds at 1.0 m or less. The first frame is
// aligned by picks that are a centimetre and a degree off. An error where it does not show the
// object.
[[nodiscard]] Result<std::vector<TriedPart>> run_part(const PartRow& row, std::uint32_t seed);

}  // namespace spool::campaign
