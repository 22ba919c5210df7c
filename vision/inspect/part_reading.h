// A part's mean deviation over the frames of a live camera.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool {

struct PartReading {
  bool is_seen = false;  // any of it; else the rest means nothing
  double mean_m = 0;     // mean signed deviation of its surface that was seen, + outside the design
  double u_m = 0;        // of the mean: two standard deviations, the doubt of the pose in it
  double coverage = 0;   // share of its surface that is known well enough for a number, 0 to 1
};

}  // namespace spool
