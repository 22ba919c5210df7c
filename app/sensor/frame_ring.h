// The last seconds of what a sensor gave, always there to be saved.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "app/sensor/packed_depth.h"

namespace spool::sensor {

using PackedDepthPtr = std::shared_ptr<const PackedDepth>;

struct FrameRingOptions {
  double seconds = 10;                                 // s, by the frames' own clock
  std::size_t frames = 900;                            // where the clock stands: ten seconds at 90
  std::size_t bytes = std::size_t{256} * 1024 * 1024;  // packed; fewer seconds where they need more
};

// The oldest frames make room for new ones. All functions from any thread.
class FrameRing {
 public:
  explicit FrameRing(const FrameRingOptions& options = {}) : options_(options) {}

  // Packs the frame, which takes a millisecond or two. A clock that goes back begins anew: what was
  // before belongs to another stream.
  void add(const DepthFrame& frame);
  // Oldest first.
  [[nodiscard]] std::vector<PackedDepthPtr> frames() const;

 private:
  FrameRingOptions options_;
  mutable std::mutex mutex_;
  std::deque<PackedDepthPtr> frames_;
  std::size_t bytes_ = 0;
};

}  // namespace spool::sensor
