// Tables 5-1 to 5-4 from scenes of our own, the printed numbers beside them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <ostream>

#include "vision/core/cancel.h"
#include "vision/core/result.h"

namespace spool::thesis {

// All four tables as text to `out`: scenes of Table 5-4's sizes, each decluttered with its true
// pose put off by the thesis's own RMS (what the finder does is chapter 4's), Algorithm 2 over
// Algorithm 1's K, the curves, the plane.
[[nodiscard]] Status print_declutter_tables(std::uint32_t seed, std::ostream& out,
                                            const Watch& watch);

}  // namespace spool::thesis
