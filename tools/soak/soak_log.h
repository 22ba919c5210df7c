// What a soak notes while it plays: memory by play-back time, and the verdict at the end.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/soak/memory.h"

namespace spool::soak {

constexpr double kBudgetMib = 1024;   // at most, ever
constexpr double kMostGrowth = 0.05;  // an hour, of what it was once it had settled: flat

// Time is the play-back's. One thread.
class MemoryLog {
 public:
  // `planned_s`: of the whole run. Memory may grow while maps and pools fill: for two minutes, or
  // for a quarter of a shorter run.
  explicit MemoryLog(double planned_s);

  void add(double seconds, const Resident& resident);
  [[nodiscard]] const std::vector<MemorySample>& samples() const { return samples_; }
  [[nodiscard]] double settle_s() const { return settle_s_; }

  struct Verdict {
    bool is_flat = false;         // growth is not surely more than kMostGrowth
    bool is_surely_flat = false;  // it is surely less
    bool is_in_budget = false;    // the peak is under kBudgetMib
    double start_mib = 0, settled_mib = 0, end_mib = 0, peak_mib = 0;
    MemoryTrend trend;  // since it settled
  };
  // Nothing where the run was too short to tell.
  [[nodiscard]] std::optional<Verdict> verdict() const;

 private:
  double settle_s_;
  std::vector<MemorySample> samples_;
  double peak_mib_ = 0;
};

// Prints memory and verdict; the exit code: 0 flat and within the budget, 1 not.
[[nodiscard]] int print_verdict(const MemoryLog& log);

}  // namespace spool::soak
