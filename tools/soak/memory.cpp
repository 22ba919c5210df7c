// What a process holds of memory, and whether that grows.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/soak/memory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>

#include "vision/core/median.h"

namespace spool::soak {
namespace {

constexpr std::size_t kStretches = 24;
constexpr std::size_t kFewest = 4;
constexpr double kTwoSided95 = 1.96;

// Medians of stretches that hold equally many samples, in order of time.
std::vector<MemorySample> stretches(const std::vector<MemorySample>& samples) {
  const std::size_t count = std::min(kStretches, samples.size());
  std::vector<MemorySample> out;
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t from = s * samples.size() / count, to = (s + 1) * samples.size() / count;
    std::vector<double> seconds, mib;
    for (std::size_t i = from; i < to; ++i) {
      seconds.push_back(samples[i].seconds);
      mib.push_back(samples[i].mib);
    }
    out.push_back({median(seconds), median(mib)});
  }
  return out;
}

}  // namespace

std::optional<Resident> resident_memory(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/status");
  std::optional<double> now, peak;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string what;
    double kib = 0;  // the kernel's kB
    if (!(words >> what >> kib)) continue;
    if (what == "VmRSS:") now = kib / 1024;
    if (what == "VmHWM:") peak = kib / 1024;
  }
  if (!now || !peak) return std::nullopt;  // ended, and not yet waited for
  return Resident{*now, *peak};
}

std::optional<MemoryTrend> memory_trend(const std::vector<MemorySample>& samples) {
  if (samples.size() < kFewest) return std::nullopt;
  const std::vector<MemorySample> points = stretches(samples);
  std::vector<double> slopes;  // MiB an hour
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (points[j].seconds > points[i].seconds)
        slopes.push_back(3600 * (points[j].mib - points[i].mib) /
                         (points[j].seconds - points[i].seconds));
  if (slopes.empty()) return std::nullopt;
  std::sort(slopes.begin(), slopes.end());
  const auto n = static_cast<double>(points.size());
  const double spread = kTwoSided95 * std::sqrt(n * (n - 1) * (2 * n + 5) / 18);
  const auto last = static_cast<double>(slopes.size() - 1);
  const auto ranked = [&](double rank) {
    return slopes[static_cast<std::size_t>(std::lround(std::clamp(rank, 0.0, last)))];
  };
  return MemoryTrend{ranked(0.5 * last), ranked(0.5 * (last - spread)),
                     ranked(0.5 * (last + spread))};
}

}  // namespace spool::soak
