// What a soak notes while it plays.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/soak/soak_log.h"

#include <algorithm>
#include <cstdio>

namespace spool::soak {
namespace {
constexpr double kSettles = 120;  // s
}

MemoryLog::MemoryLog(double planned_s) : settle_s_(std::min(kSettles, planned_s / 4)) {}

void MemoryLog::add(double seconds, const Resident& resident) {
  samples_.push_back({seconds, resident.now_mib});
  peak_mib_ = std::max(peak_mib_, resident.peak_mib);
}

std::optional<MemoryLog::Verdict> MemoryLog::verdict() const {
  const auto settled =
      std::find_if(samples_.begin(), samples_.end(),
                   [&](const MemorySample& sample) { return sample.seconds >= settle_s_; });
  const auto trend = memory_trend({settled, samples_.end()});
  if (!trend) return std::nullopt;
  Verdict verdict;
  verdict.start_mib = samples_.front().mib;
  verdict.settled_mib = settled->mib;
  verdict.end_mib = samples_.back().mib;
  verdict.peak_mib = peak_mib_;
  verdict.trend = *trend;
  verdict.is_flat = trend->low <= kMostGrowth * verdict.settled_mib;
  verdict.is_surely_flat = trend->high <= kMostGrowth * verdict.settled_mib;
  verdict.is_in_budget = peak_mib_ < kBudgetMib;
  return verdict;
}

int print_verdict(const MemoryLog& log) {
  const auto verdict = log.verdict();
  if (!verdict) {
    std::printf("too short to say anything of memory\n");
    return 1;
  }
  std::printf(
      "resident MiB: %.1f at the start, %.1f after %.1f min, %.1f at the end, %.1f at most\n",
      verdict->start_mib, verdict->settled_mib, log.settle_s() / 60, verdict->end_mib,
      verdict->peak_mib);
  std::printf(
      "growth from then on: %+.1f MiB an hour (95 %%: %+.1f to %+.1f), %+.1f %% of what it was\n",
      verdict->trend.per_hour, verdict->trend.low, verdict->trend.high,
      100 * verdict->trend.per_hour / verdict->settled_mib);
  std::printf("%s: flat is up to %.0f %% an hour; %s the budget of %.0f MiB\n",
              !verdict->is_flat         ? "NOT FLAT"
              : verdict->is_surely_flat ? "flat"
                                        : "flat as far as so short a run can tell",
              100 * kMostGrowth, verdict->is_in_budget ? "within" : "OVER", kBudgetMib);
  return verdict->is_flat && verdict->is_in_budget ? 0 : 1;
}

}  // namespace spool::soak
