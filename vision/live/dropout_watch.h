// Notices that a picture suddenly lost most of its depth: the flash of an arc, a hand on the lens.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>

#include "vision/core/depth_frame.h"

namespace spool {

// No picture of anything: no reading, or all of them one value. Even of a wall they differ.
[[nodiscard]] bool is_blank(const DepthFrame& frame);

// An arc that is struck blinds a structured-light sensor for tenths of a second. What is left of
// such a picture says nothing of where the camera is, but the camera is where it was: better to
// wait for a moment than to be lost. One thread at a time.
//
// The share of readings that a picture has more or less than the one before is counted; a dropout
// loses most of them, and more than the last second's pictures would by chance.
class DropoutWatch {
 public:
  // True from the picture that fell out to the one that is back, for a second at most: what is gone
  // for longer is no flash, and has to be dealt with as it is.
  [[nodiscard]] bool is_out(const DepthFrame& frame);

 private:
  [[nodiscard]] double limit() const;
  [[nodiscard]] bool lasts(double seconds);

  double readings_ = 0;         // sampled, of the last picture that was not out; 0: none yet
  std::deque<double> changes_;  // of that number from picture to picture, as shares of it
  int out_ = 0;                 // pictures on end
  double out_from_s_ = 0;       // source's clock
};

}  // namespace spool
