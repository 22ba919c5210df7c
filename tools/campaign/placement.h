// Puts the object down, any side up, on floor, stands or a table, with scanner stations round it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/clutter.h"

namespace spool::campaign {

// The pose in which an assembly lies on z = `height` round the origin: one side of its box down (of
// a flat thing mostly the flat one), up to 3 degrees off level unless it is a frame on the floor.
[[nodiscard]] Pose laid_down(const Assembly& assembly, double height, bool level, Random& random);

// The lowest height (m) of an assembly that stands at `T_scan_design`.
[[nodiscard]] double lowest_of(const Assembly& assembly, const Pose& T_scan_design);

// Up to three stands from the floor to the underside of the object, as far apart as may be.
void add_stands(const std::vector<Placed>& object, Random& random, Room& room);

// `count` places 1.2 to 1.8 m high round the object, outside all that is taken and inside the room,
// which grows if it has to.
[[nodiscard]] std::vector<Eigen::Vector3d> stations_round(const Eigen::AlignedBox3d& object,
                                                          int count, Random& random, Room& room);

}  // namespace spool::campaign
