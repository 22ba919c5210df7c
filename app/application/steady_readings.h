// Parts' numbers that stand still on the screen until they changed by more than their uncertainty.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/inspect/part_reading.h"

namespace spool {

// A new look moves every mean by a little of its doubt, thirty times a second: nobody can read
// that. One thread.
class SteadyReadings {
 public:
  // The readings of the next state, one a part. A mean steps where it differs from the one held by
  // more than the new one's u_m. u_m itself grows at once, and shrinks where it halved. `afresh`:
  // everything is as it is now (another alignment, a picture that is held).
  void follow(const std::vector<PartReading>& now, bool afresh);
  [[nodiscard]] const std::vector<PartReading>& held() const { return held_; }

 private:
  std::vector<PartReading> held_;
};

// Whether a part was moved from one state to another: the doubts of its two means do not meet.
[[nodiscard]] bool has_moved(const std::vector<PartReading>& before,
                             const std::vector<PartReading>& now);

}  // namespace spool
