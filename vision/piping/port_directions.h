// Which way each end of a component looks, from its own points or from what it is joined to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vision/piping/pipework.h"

namespace spool::piping {

// Unit directions out of the component, one a port; zero where its own points do not tell.
[[nodiscard]] std::vector<Eigen::Vector3d> own_directions(const Component& component);

// With the joints known: elbows without a centre get it where the axes of both neighbours meet (a
// problem says so, or that they do not), ends without a direction look at their neighbour, and the
// face of every flange is found.
void complete_directions(Pipework& pipework);

}  // namespace spool::piping
