// When a recorded frame is due: as fast as it is read, in real time, or a multiple of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

namespace spool::sensor {

// One thread. The clock starts with the first frame asked about.
class PlaybackPace {
 public:
  explicit PlaybackPace(double speed) : speed_(speed) {}

  // Sleeps until the frame recorded at `seconds` is due, but not past `deadline`; true when it is
  // due.
  [[nodiscard]] bool wait_for(double seconds, std::chrono::steady_clock::time_point deadline) {
    if (speed_ <= 0) return true;
    if (!start_) {
      start_ = std::chrono::steady_clock::now();
      first_seconds_ = seconds;
    }
    const std::chrono::duration<double> after((seconds - first_seconds_) / speed_);
    const auto due =
        *start_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(after);
    std::this_thread::sleep_until(std::min(due, deadline));
    return std::chrono::steady_clock::now() >= due;
  }

 private:
  double speed_;  // 0: at once
  std::optional<std::chrono::steady_clock::time_point> start_;
  double first_seconds_ = 0;  // s
};

}  // namespace spool::sensor
