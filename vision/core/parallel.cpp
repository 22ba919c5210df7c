// Data-parallel loops: oneTBB behind a plain function.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/parallel.h"

#include <cassert>

#ifndef SPOOL_SERIAL
#include <oneapi/tbb/parallel_for.h>
#endif

namespace spool {

void parallel_chunks(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  assert(grain > 0 && "a chunk holds at least one index");
  const std::size_t chunks = (count + grain - 1) / grain;
  const auto run = [&](std::size_t chunk) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain));
  };
#ifdef SPOOL_SERIAL
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
#else
  if (chunks == 1) {
    run(0);
    return;
  }
  tbb::parallel_for(std::size_t{0}, chunks, run);
#endif
}

}  // namespace spool
