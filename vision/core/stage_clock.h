// Times the stages of a computation, one after the other, into a table of seconds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace spool {

// Starts with the first stage. The table must outlive the clock. One thread.
class StageClock {
 public:
  explicit StageClock(std::map<std::string, double>& timing_s) : timing_s_(timing_s) {}

  // Adds the seconds since the last mark, or since the start, to the stage that ends here.
  void mark(const char* stage) {
    const Clock::time_point now = Clock::now();
    timing_s_[stage] += seconds(now - last_);
    last_ = now;
  }
  // Seconds from the start to the last mark: the sum of what this clock has marked.
  [[nodiscard]] double total_s() const { return seconds(last_ - start_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
  }

  std::map<std::string, double>& timing_s_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace spool
