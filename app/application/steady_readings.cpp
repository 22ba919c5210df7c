// Parts' numbers that stand still on the screen until they changed by more than their uncertainty.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/steady_readings.h"

#include <algorithm>
#include <cmath>

namespace spool {

void SteadyReadings::follow(const std::vector<PartReading>& now, bool afresh) {
  if (afresh || held_.size() != now.size()) {
    held_ = now;
    return;
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    PartReading& held = held_[i];
    PartReading next = now[i];
    if (held.is_seen && next.is_seen) {
      if (std::abs(next.mean_m - held.mean_m) <= next.u_m) next.mean_m = held.mean_m;
      if (next.u_m <= held.u_m && 2 * next.u_m > held.u_m) next.u_m = held.u_m;
    }
    held = next;
  }
}

bool has_moved(const std::vector<PartReading>& before, const std::vector<PartReading>& now) {
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
    const PartReading &a = before[i], &b = now[i];
    if (a.is_seen && b.is_seen && std::abs(a.mean_m - b.mean_m) > a.u_m + b.u_m) return true;
  }
  return false;
}

}  // namespace spool
