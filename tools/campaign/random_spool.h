// Spools that nobody drew: a random walk of standard parts that does not run into itself.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

// NPS 2 to 8, 7 to 24 parts, 0.5 to 3.5 m across, with at least two bends or tees in it.
[[nodiscard]] Assembly random_spool(std::uint32_t seed);

}  // namespace spool::campaign
