// How a caller watches a long computation and ends it: progress and cancel, from any thread.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string_view>
#include <vector>

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

// Calls `body(i)` for every i below `count`, in order, on this thread. False where it was cancelled
// on the way. `body` may take a microsecond.
template <class Body>
bool watched_loop(std::size_t count, const Watch& watch, const Body& body) {
  constexpr std::size_t kBetweenLooks = 16384;
  for (std::size_t begin = 0; begin < count; begin += kBetweenLooks) {
    if (watch.cancelled()) return false;
    const std::size_t end = std::min(count, begin + kBetweenLooks);
    for (std::size_t i = begin; i < end; ++i) body(i);
  }
  return true;
}

// Fills an empty vector with `count` times `value`. False, and empty again, where it was cancelled
// on the way: of millions of elements the first touch of their memory alone takes a second.
template <class T>
bool watched_fill(std::vector<T>& to, std::size_t count, const T& value, const Watch& watch) {
  constexpr std::size_t kBetweenLooks = 65536;
  to.reserve(count);
  while (to.size() < count && !watch.cancelled())
    to.resize(std::min(count, to.size() + kBetweenLooks), value);
  if (to.size() == count) return true;
  to = {};
  return false;
}

}  // namespace spool
