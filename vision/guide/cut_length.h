// How long a design's pipe is sawn: from centre to centre less take-offs and root gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "vision/guide/joint_ends.h"

namespace spool::guide {

// What a job does about root gaps: drawings that dimension fittings end to end leave it open.
enum class GapRule {
  kNone,         // pipes are sawn as drawn, gaps are absorbed
  kSubtract,     // each butt weld drawn without a gap takes root_gap_m off its pipe
  kModelHasGaps  // the design is drawn with its gaps: pipes are sawn as drawn
};
[[nodiscard]] std::string_view name(GapRule rule);  // none subtract model-has-gaps
[[nodiscard]] std::optional<GapRule> parse_gap_rule(std::string_view text);

struct GapPolicy {
  GapRule rule = GapRule::kNone;
  double root_gap_m = 0;
};

// One end of a pipe; -1: open.
struct CutEnd {
  int neighbour = -1;
  double take_off_m = 0;  // from the neighbour's centre, face or far end to its port
  double gap_m = 0;       // what the root gap takes off this pipe
};

struct CutLength {
  double drawn_m = 0;  // between the pipe's ends in the design
  std::array<CutEnd, 2> ends;
  [[nodiscard]] double centre_to_centre_m() const {
    return drawn_m + ends[0].take_off_m + ends[1].take_off_m;
  }
  [[nodiscard]] double cut_m() const { return drawn_m - ends[0].gap_m - ends[1].gap_m; }
};

// The cut of a pipe; nothing for other parts and for a pipe without two ends in line. A butt weld
// between two pipes takes half its gap off each. `ends` is joint_ends(). Pure; any thread.
[[nodiscard]] std::optional<CutLength> cut_length(const DesignModel& design,
                                                  const std::vector<std::vector<JointEnd>>& ends,
                                                  int part, const GapPolicy& policy);

// The length (m) that a fitting or flange takes from a run at `port`: to where its axes meet, else
// along the axis to its furthest other port. 0 for pipes.
[[nodiscard]] double take_off_m(const Part& part, int port);

}  // namespace spool::guide
