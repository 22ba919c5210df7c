// What else stands in the room: floor, walls, tables, stands, boxes, drums, pipes and frames.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/campaign/assembly.h"
#include "tools/campaign/random.h"
#include "tools/campaign/ray_world.h"

namespace spool::campaign {

using Boxes = std::vector<Eigen::AlignedBox3d>;

// Everything stands on z = 0 round the origin.
struct Room {
  std::vector<Placed> placed = {};
  Boxes taken = {};  // m: where nothing else may stand
  double half_x = 4, half_y = 4, height = 3;
};

// Adds every patch of an assembly's members (missing ones left out) and takes their room. Labels
// count from `label` where `counted`, else all are `label`.
void add_assembly(const Assembly& assembly, const std::vector<Pose>& T_scan_part,
                  std::uint16_t label, bool counted, std::uint8_t instance, Room& room);

// A box, drawn round its middle and turned about z; takes no room by itself.
void add_block(const Eigen::Vector3d& middle, const Eigen::Vector3d& half, double yaw_rad,
               std::uint16_t label, Room& room);

void add_floor_and_walls(Room& room);

// A level rectangle that things lie on.
struct Ground {
  Eigen::Vector2d middle = {0, 0}, half = {0, 0};  // m
  double height = 0;                               // m; over 0: a table's top, for small things
};

// A table with that top.
void add_table(const Ground& top, Room& room);

// Items at random until about `area` (m2) of them could be seen or nothing more fits. `sizes` are
// the pipe sizes that lie about; the nearer to the middle the likelier.
void add_items(double area, const Ground& ground, const std::vector<double>& sizes, Random& random,
               Room& room);

}  // namespace spool::campaign
