// The cut list: how long each pipe is sawn, from centre to centre less take-offs and root gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/piping/pipework.h"

namespace spool::piping {

// One end of a cut pipe.
struct CutEnd {
  int neighbour = -1;   // component; -1: open
  double take_off = 0;  // m from the neighbour's centre (or face) to its end
  double root_gap = 0;  // m that the gap takes off this pipe
};

struct CutPipe {
  int component = -1;
  double drawn = 0;  // m between its ends in the file
  CutEnd ends[2];
  // From the neighbours' centres or faces, m.
  [[nodiscard]] double centre_to_centre() const {
    return drawn + ends[0].take_off + ends[1].take_off;
  }
  [[nodiscard]] double cut() const { return drawn - ends[0].root_gap - ends[1].root_gap; }
};

// Every pipe with its neighbours. A butt weld that the file draws without a gap takes `root_gap`
// (m) off the pipe, half of it where both sides are pipes; one that the file draws with its gap
// takes nothing more.
[[nodiscard]] std::vector<CutPipe> cut_list(const Pipework& pipework, double root_gap);

// The length (m) of a fitting or flange that a pipe's length loses at this port: to its centre,
// else to its other end.
[[nodiscard]] double take_off(const Component& component, int port);

}  // namespace spool::piping
