// Depth images packed without loss, small and fast enough to keep a sensor's last seconds in
// memory.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vision/core/depth_frame.h"

namespace spool::sensor {

struct PackedDepth {
  std::int64_t index = 0;  // of the frame, and its clock (s), as DepthFrame has them
  double seconds = 0;
  int width = 0, height = 0;  // px
  std::vector<std::uint8_t> bytes = {};
};

// Any frame whose size and depth agree. Runs of zeros, and of the others the differences from each
// to the next, in groups of three bits: RVL, Wilson, "Fast lossless depth image compression", 2017.
// Any thread.
[[nodiscard]] PackedDepth pack(const DepthFrame& frame);
// The same frame again, bit for bit.
[[nodiscard]] DepthFrame unpack(const PackedDepth& packed);

}  // namespace spool::sensor
