// One check of a step at the table: its words and times.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/job/check_record.h"

#include <cmath>
#include <ctime>
#include <fstream>

#include <fmt/format.h>

namespace spool::job {

std::string_view name(Phase phase) {
  switch (phase) {
    case Phase::kBeforeTack:
      return "before-tack";
    case Phase::kAfterTack:
      return "after-tack";
    case Phase::kBeforeWeld:
      return "before-weld";
    case Phase::kAfterWeld:
      return "after-weld";
  }
  return "";
}

std::optional<Phase> parse_phase(std::string_view text) {
  for (const Phase phase :
       {Phase::kBeforeTack, Phase::kAfterTack, Phase::kBeforeWeld, Phase::kAfterWeld}) {
    if (text == name(phase)) return phase;
  }
  return std::nullopt;
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::kAccept:
      return "accept";
    case Outcome::kRemark:
      return "remark";
    case Outcome::kRedo:
      return "redo";
  }
  return "";
}

std::optional<Outcome> parse_outcome(std::string_view text) {
  for (const Outcome outcome : {Outcome::kAccept, Outcome::kRemark, Outcome::kRedo}) {
    if (text == name(outcome)) return outcome;
  }
  return std::nullopt;
}

Stamp now() {
  const auto seconds = [](clockid_t clock) {
    timespec time{};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
  };
  Stamp stamp;
  stamp.wall_s = seconds(CLOCK_REALTIME);
  stamp.boot_s = seconds(CLOCK_BOOTTIME);
  std::ifstream("/proc/sys/kernel/random/boot_id") >> stamp.boot;
  return stamp;
}

std::optional<double> seconds_between(const Stamp& a, const Stamp& b) {
  if (!a.boot.empty() && a.boot == b.boot && b.boot_s >= a.boot_s) return b.boot_s - a.boot_s;
  if (b.wall_s >= a.wall_s) return b.wall_s - a.wall_s;
  return std::nullopt;
}

std::string utc_text(double wall_s) {
  constexpr double kYear10000 = 253402300800.0;
  if (!std::isfinite(wall_s) || wall_s < 0 || wall_s >= kYear10000) return "-";
  const double whole = std::floor(wall_s);
  const auto seconds = static_cast<std::time_t>(whole);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900,
                     utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec,
                     static_cast<int>((wall_s - whole) * 1000));
}

}  // namespace spool::job
