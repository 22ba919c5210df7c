// How a flange is turned about its axis: the phase of its bolt holes, over many frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/inspect/bolt_ring.h"

namespace spool {

// A flange as seen is turned from where the design has it by so much, right-handed about its axis,
// modulo the pitch of its holes.
struct BoltTurn {
  double turn_rad = 0;   // within half a pitch
  double sigma_rad = 0;  // one standard deviation
};

struct BoltPhaseOptions {
  // What the holes' edges err by together, round the bolt circle, in pixels of the picture: how
  // they fall on its grid. No number of looks averages that away.
  double bias_px = 0.25;
  double look_s = 0.3;  // frames of so long are one look
};

// Round the ring the share of pixels that look through goes with the angle as the holes do, to
// first order as a + b cos(n angle) + c sin(n angle): the phase of that is the holes' clocking,
// whatever their size, and however many pixels one of them has. The first two harmonics are fitted
// beside it: of a rim or an edge that got into the ring they take the most. What the view's slant
// hides of each hole is the same way for all of them and cancels over a turn.
class BoltPhase {
 public:
  BoltPhase(const BoltHoles& holes, const BoltPhaseOptions& options);

  void clear();
  // `passed_s`: since the look before.
  void add(const BoltLook& look, double passed_s);
  // The scan was turned by so much about the axis: what was seen goes with it.
  void follow(double angle_rad) { turned_rad_ += angle_rad; }

  // Nothing until three holes and three of four of those seen stand out each by itself, and the
  // whole by six standard deviations: of the looks about their mean, for what one look has of them
  // is the same pixels over and over.
  [[nodiscard]] std::optional<BoltTurn> turn() const;

 private:
  using Bins = std::vector<RingBin>;
  [[nodiscard]] Bins all_bins() const;
  [[nodiscard]] double scatter_of_phase(const Bins& all,
                                        const std::complex<double>& direction) const;

  BoltHoles holes_;
  BoltPhaseOptions options_;
  double turned_rad_ = 0;        // since clear()
  std::vector<BoltLook> looks_;  // of late; by the angle less turned_rad_ at the time
  double look_age_s_ = 0;        // of the last of them
};

}  // namespace spool
