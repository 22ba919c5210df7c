// Depth images as 16-bit grey PNG, bit for bit.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vision/core/result.h"

namespace spool::sensor {

// The counts (row-major, row 0 at the top) of the PNG in `bytes`, which must be width x height, one
// channel of 16 bits. kBadInput, naming `name`, for anything else and for a file that is damaged or
// cut short.
[[nodiscard]] Result<std::vector<std::uint16_t>> decode_depth_png(std::string_view bytes, int width,
                                                                  int height,
                                                                  const std::string& name);

// A PNG of width x height counts, packed fast rather than small: it has to keep up with 30 frames a
// second.
[[nodiscard]] Result<std::string> encode_depth_png(std::span<const std::uint16_t> depth, int width,
                                                   int height);

}  // namespace spool::sensor
