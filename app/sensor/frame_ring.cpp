// The last seconds of what a sensor gave.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/frame_ring.h"

#include <cmath>
#include <utility>

namespace spool::sensor {

void FrameRing::add(const DepthFrame& frame) {
  if (!frame.is_consistent() || !std::isfinite(frame.seconds)) return;
  auto packed = std::make_shared<const PackedDepth>(pack(frame));
  const std::scoped_lock lock(mutex_);
  if (!frames_.empty() && packed->seconds < frames_.back()->seconds) {
    frames_.clear();
    bytes_ = 0;
  }
  bytes_ += packed->bytes.size();
  frames_.push_back(std::move(packed));
  while (frames_.size() > 1 &&
         (frames_.back()->seconds - frames_.front()->seconds > options_.seconds ||
          frames_.size() > options_.frames || bytes_ > options_.bytes)) {
    bytes_ -= frames_.front()->bytes.size();
    frames_.pop_front();
  }
}

std::vector<PackedDepthPtr> FrameRing::frames() const {
  const std::scoped_lock lock(mutex_);
  return {frames_.begin(), frames_.end()};
}

}  // namespace spool::sensor
