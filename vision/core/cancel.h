// How a caller watches a long computation and ends it: progress and cancel, from any thread.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace spool {

// Passed down long functions. `progress` (may be empty) is called on the computing thread with the
// stage and its share done in 0..1; `stop` is looked at often enough to end within 100 ms.
struct Watch {
  std::stop_token stop;
  std::function<void(std::string_view stage, double fraction)> progress;

  [[nodiscard]] bool cancelled() const { return stop.stop_requested(); }
  void report(std::string_view stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
};

}  // namespace spool
