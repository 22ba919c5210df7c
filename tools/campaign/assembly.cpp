// Parts joined port to port: a plan of how, and where each part then stands.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/assembly.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <numbers>

namespace spool::campaign {

int Assembly::join(const PartSpec& spec, int parent, int port, int own_port, double roll_rad) {
  assert(parent >= 0 && parent < static_cast<int>(members.size()) && "a member joins another");
  members.push_back({spec, parent, port, own_port, roll_rad});
  return static_cast<int>(members.size()) - 1;
}

int Assembly::place(const PartSpec& spec, const Pose& T_design_part) {
  Member member{spec};
  member.T_base_part = T_design_part;
  members.push_back(member);
  return static_cast<int>(members.size()) - 1;
}

int Assembly::weld_on(const PartSpec& spec, int parent, const Pose& T_parent_part) {
  const int part = join(spec, parent, -1);
  members.back().T_base_part = T_parent_part;
  return part;
}

std::vector<Pose> poses_of(const Assembly& assembly) {
  const std::size_t count = assembly.members.size();
  std::vector<Pose> poses(count, Pose::Identity());
  std::vector<bool> known(count, false);
  const std::function<const Pose&(std::size_t)> pose_of = [&](std::size_t i) -> const Pose& {
    if (known[i]) return poses[i];
    const Member& member = assembly.members[i];
    if (member.parent < 0) {
      poses[i] = member.T_base_part;
    } else if (member.parent_port < 0) {
      poses[i] = pose_of(static_cast<std::size_t>(member.parent)) * member.T_base_part;
    } else {
      const auto parent = static_cast<std::size_t>(member.parent);
      const auto ports = ports_of(assembly.members[parent].spec);
      const auto own = ports_of(member.spec);
      // Face to face: half a turn about the port's x brings the part's outward z against it.
      const Eigen::AngleAxisd roll(member.roll_rad, Eigen::Vector3d::UnitZ());
      const Eigen::AngleAxisd facing(std::numbers::pi, Eigen::Vector3d::UnitX());
      poses[i] = pose_of(parent) * ports[static_cast<std::size_t>(member.parent_port)].T_part_port *
                 roll * member.joint_error * facing *
                 own[static_cast<std::size_t>(member.own_port)].T_part_port.inverse();
    }
    known[i] = true;
    return poses[i];
  };
  for (std::size_t i = 0; i < count; ++i) pose_of(i);
  return poses;
}

bool hangs_on(const Assembly& assembly, int part, int ancestor) {
  for (; part >= 0; part = assembly.members[static_cast<std::size_t>(part)].parent)
    if (part == ancestor) return true;
  return false;
}

std::vector<std::size_t> ends_of(const Assembly& assembly) {
  std::vector<std::size_t> ends;
  const auto& members = assembly.members;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto hangs = [&](const Member& m) { return m.parent == static_cast<int>(i); };
    if (members[i].parent >= 0 && std::none_of(members.begin(), members.end(), hangs))
      ends.push_back(i);
  }
  return ends;
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
