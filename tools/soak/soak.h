// The two things that a soak plays a recording through: vision alone, and the whole program.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "vision/core/result.h"

namespace spool::soak {

struct SoakRequest {
  std::string design, source;
  double minutes = 60;  // of play-back
  bool real_time = false;
  std::filesystem::path script;             // taps that align, for the whole program
  const std::atomic<bool>* stop = nullptr;  // set from outside: end early
};

// Source, tracking, map and deviations, as the vision thread calls them, one frame after the other.
// The spool is found by itself. The exit code of print_verdict().
[[nodiscard]] Result<int> soak_vision(const SoakRequest& request);

// The program `spoolsight` beside this one, headless, in lock step with the recording: GL and
// screens too. It is watched from outside.
[[nodiscard]] Result<int> soak_program(const SoakRequest& request);

}  // namespace spool::soak
