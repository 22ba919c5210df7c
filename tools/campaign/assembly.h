// Parts joined port to port: a plan of how, and where each part then stands.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/campaign/part.h"

namespace spool::campaign {

// A part and the joint that holds it. Port against port with opposite z axes; `roll_rad` turns the
// part about the parent port's outward z, right-handed.
struct Member {
  PartSpec spec;
  int parent = -1;  // a member before this one; -1: stands at T_design_part
  int parent_port = 0, own_port = 0;
  double roll_rad = 0;
  Pose T_design_part = Pose::Identity();
  bool missing = false;  // its place counts for what follows, but nothing stands there
};

struct Assembly {
  std::string name;
  std::vector<Member> members;

  // Adds a part to `port` of member `parent` by its own port and gives its index.
  int join(const PartSpec& spec, int parent, int port, int own_port = 0, double roll_rad = 0);
  int place(const PartSpec& spec, const Pose& T_design_part);
};

// T_design_part of every member.
[[nodiscard]] std::vector<Pose> poses_of(const Assembly& assembly);

// True where member `part` hangs on `ancestor`, through others or itself.
[[nodiscard]] bool hangs_on(const Assembly& assembly, int part, int ancestor);

// Corners of a box round all members, design frame (m).
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Assembly& assembly);

}  // namespace spool::campaign
