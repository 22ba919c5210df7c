// What a point shows that is no part of the object: the numbers in labels.bin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace spool::campaign {

// Below kFloor: the member of the as-built assembly.
inline constexpr std::uint16_t kFloor = 1000, kWall = 1001, kTable = 1002, kStand = 1003,
                               kBox = 1004, kCylinder = 1005, kOtherPipe = 1006, kStructure = 1007,
                               kMixedPixel = 1099;

}  // namespace spool::campaign
