// What a branch fitting without ends of its own on the run sits on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/piping/pipework.h"

namespace spool::piping {

// The component whose axis passes within 2 mm of the fitting's centre, the nearest of them; -1
// where there is none. Pipes before fittings where both are as near.
[[nodiscard]] int run_of_branch(const Pipework& pipework, int fitting);

}  // namespace spool::piping
