// What a process holds of memory, and whether that grows: a slope with its uncertainty.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <sys/types.h>

namespace spool::soak {

// Of a running process, MiB: what lies in memory now, and the most that ever did.
struct Resident {
  double now_mib = 0, peak_mib = 0;
};
// Nothing where the process is gone. Source: /proc/PID/status, VmRSS and VmHWM.
[[nodiscard]] std::optional<Resident> resident_memory(pid_t process);

struct MemorySample {
  double seconds = 0;
  double mib = 0;
};

// Growth in MiB an hour and its 95 % interval.
struct MemoryTrend {
  double per_hour = 0, low = 0, high = 0;
};

// The median of the slopes between all pairs of points (Theil 1950) and Sen's interval about it
// (Sen 1968, by the variance of Kendall's S), so that neither a step nor a spike is taken for
// growth that goes on. The points are the medians of up to two dozen stretches of time, since what
// was resident a second ago mostly still is, and samples of every second are worth far fewer. Of
// fewer than four samples: nothing.
[[nodiscard]] std::optional<MemoryTrend> memory_trend(const std::vector<MemorySample>& samples);

}  // namespace spool::soak
