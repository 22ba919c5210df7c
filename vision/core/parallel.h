// Data-parallel loops over index ranges; deterministic whatever the number of threads.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace spool {

// Calls `body(begin, end)` on chunks of [0, count) of `grain` indices (the last may be shorter), on
// oneTBB's threads; returns when all are done. Serial under SPOOL_SERIAL: Debian's TBB is not
// instrumented for the thread sanitizer.
void parallel_chunks(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

// Sums `map(begin, end)` over the same chunks, always added in index order, so that the result is
// the same to the last bit on any number of threads. T needs operator+=.
template <class T, class Map>
[[nodiscard]] T parallel_sum(std::size_t count, std::size_t grain, T zero, const Map& map) {
  if (count == 0) return zero;
  const std::size_t chunks = (count + grain - 1) / grain;
  std::vector<T> parts(chunks, zero);
  parallel_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
    parts[begin / grain] = map(begin, end);
  });
  T sum = zero;
  for (const T& part : parts) sum += part;
  return sum;
}

}  // namespace spool
