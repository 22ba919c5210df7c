// Which ends of a pipework meet: joints by nearness, welds to their joints, branch fittings to
// their runs.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "vision/piping/pipework.h"

namespace spool::piping {

inline constexpr double kMeets = 0.0005;  // m: ends this near are one place
inline constexpr double kNearby = 0.006;  // m: ends this near belong together, with a gap

// Fills joints, and directions and faces of components. Ends within kMeets meet; within kNearby
// they are joined too and the gap or overlap is a problem at its line; nothing is ever moved. A gap
// that a WELD record spans is its root gap and no problem. Elbows without a centre get it where
// their neighbours' axes meet, single ends their direction from what they sit on. Problems: ends
// of different bore or type, three ends at one place, welds and branch fittings on nothing.
void connect(Pipework& pipework);

// BW SW SC FL ... of a port: as the file says, else by symbol key and kind; "" where nothing tells.
[[nodiscard]] std::string end_type(const Component& component, int port);

}  // namespace spool::piping
