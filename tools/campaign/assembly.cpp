// Parts joined port to port: a plan of how, and where each part then stands.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/assembly.h"

#include <cassert>
#include <numbers>

namespace spool::campaign {

int Assembly::join(const PartSpec& spec, int parent, int port, int own_port, double roll_rad) {
  assert(parent >= 0 && parent < static_cast<int>(members.size()) && "a member joins another");
  members.push_back({spec, parent, port, own_port, roll_rad});
  return static_cast<int>(members.size()) - 1;
}

int Assembly::place(const PartSpec& spec, const Pose& T_design_part) {
  Member member{spec};
  member.T_design_part = T_design_part;
  members.push_back(member);
  return static_cast<int>(members.size()) - 1;
}

std::vector<Pose> poses_of(const Assembly& assembly) {
  std::vector<Pose> poses;
  poses.reserve(assembly.members.size());
  for (const Member& member : assembly.members) {
    if (member.parent < 0) {
      poses.push_back(member.T_design_part);
      continue;
    }
    const auto parent = static_cast<std::size_t>(member.parent);
    assert(parent < poses.size() && "parents come before what hangs on them");
    const auto ports = ports_of(assembly.members[parent].spec);
    const auto own = ports_of(member.spec);
    // Face to face: half a turn about the port's x brings the part's outward z against it.
    const Eigen::AngleAxisd roll(member.roll_rad, Eigen::Vector3d::UnitZ());
    const Eigen::AngleAxisd facing(std::numbers::pi, Eigen::Vector3d::UnitX());
    poses.push_back(poses[parent] *
                    ports[static_cast<std::size_t>(member.parent_port)].T_part_port * roll *
                    facing * own[static_cast<std::size_t>(member.own_port)].T_part_port.inverse());
  }
  return poses;
}

bool hangs_on(const Assembly& assembly, int part, int ancestor) {
  for (; part >= 0; part = assembly.members[static_cast<std::size_t>(part)].parent)
    if (part == ancestor) return true;
  return false;
}

Eigen::AlignedBox3d bounds_of(const Assembly& assembly) {
  const std::vector<Pose> poses = poses_of(assembly);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (const Patch& patch : patches_of(assembly.members[i].spec)) {
      const Eigen::AlignedBox3d local = bounds(patch);
      for (int corner = 0; corner < 8; ++corner)
        box.extend(poses[i] * patch.T_part_patch *
                   local.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
  return box;
}

}  // namespace spool::campaign
