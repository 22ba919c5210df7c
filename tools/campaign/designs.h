// The objects that scenes are made of: spools of standard parts and a frame of square tube.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

enum class ObjectKind { kPipeSpool3m, kSmallSpool, kBoxFrame, kFourBranch, kRandomSpool };

// Lengths vary a little with the seed, so that no two campaigns are tuned to one object; the first
// member is the datum. `braced` gives the box frame members that break its symmetry.
[[nodiscard]] Assembly design_of(ObjectKind kind, std::uint32_t seed, bool braced);

}  // namespace spool::campaign
