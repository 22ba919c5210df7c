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
// part about the parent port's outward z, right-handed; `joint_error` is what a welder adds, seen
// from the port so turned.
struct Member {
  PartSpec spec;
  int parent = -1;                    // -1: stands at T_base_part in the design
  int parent_port = 0, own_port = 0;  // parent_port -1: stands at T_base_part on the parent
  double roll_rad = 0;
  Pose joint_error = Pose::Identity();
  Pose T_base_part = Pose::Identity();
  bool missing = false;  // its place counts for what follows, but nothing stands there
};

struct Assembly {
  std::string name;
  std::vector<Member> members;

  // Adds a part to `port` of member `parent` by its own port and gives its index.
  int join(const PartSpec& spec, int parent, int port, int own_port = 0, double roll_rad = 0);
  int place(const PartSpec& spec, const Pose& T_design_part);
  // Welds a part onto another's side, where there is no port.
  int weld_on(const PartSpec& spec, int parent, const Pose& T_parent_part);
};

// T_design_part of every member. Members may hang on later ones, but not in a circle.
[[nodiscard]] std::vector<Pose> poses_of(const Assembly& assembly);

// True where member `part` hangs on `ancestor`, through others or itself.
[[nodiscard]] bool hangs_on(const Assembly& assembly, int part, int ancestor);

// Parts that nothing hangs on and that hang on something: the far ends of branches.
[[nodiscard]] std::vector<std::size_t> ends_of(const Assembly& assembly);

// A box round all members, design frame (m).
[[nodiscard]] Eigen::AlignedBox3d bounds_of(const Assembly& assembly);

}  // namespace spool::campaign
