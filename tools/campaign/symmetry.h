// The motions that map a design onto itself, found from how it is put together.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

// Rotations with shifts, no mirrors; the identity first. Bolt holes count. A design that turns on
// its axis without end has none here: no assembly with a flange, an elbow or a tee does.
[[nodiscard]] std::vector<Pose> symmetries_of(const Assembly& assembly);

}  // namespace spool::campaign
