// The design's joints as a tree from the datum outward.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/joint_tree.h"

#include <cstddef>

namespace spool {
namespace {

// Parts reached from `start` without crossing joint `without` (-1: any), in breadth-first order.
std::vector<int> reached(const DesignModel& design, int start, int without) {
  std::vector<int> parts(1, start);
  std::vector<std::uint8_t> met(design.parts.size(), 0);
  met[static_cast<std::size_t>(start)] = 1;
  for (std::size_t at = 0; at < parts.size(); ++at)
    for (std::size_t j = 0; j < design.joints.size(); ++j) {
      if (static_cast<int>(j) == without) continue;
      const Joint& joint = design.joints[j];
      for (const auto& [from, to] :
           {std::pair(joint.part_a, joint.part_b), std::pair(joint.part_b, joint.part_a)}) {
        if (from != parts[at] || met[static_cast<std::size_t>(to)] != 0) continue;
        met[static_cast<std::size_t>(to)] = 1;
        parts.push_back(to);
      }
    }
  return parts;
}

}  // namespace

std::vector<JointBranch> joint_tree(const DesignModel& design) {
  std::vector<JointBranch> tree;
  if (design.parts.empty()) return tree;
  const int root = design.datums.empty() ? 0 : design.datums.front();
  std::vector<std::size_t> depth(design.parts.size(), design.parts.size());
  const std::vector<int> order = reached(design, root, -1);
  for (std::size_t i = 0; i < order.size(); ++i) depth[static_cast<std::size_t>(order[i])] = i;
  for (std::size_t j = 0; j < design.joints.size(); ++j) {
    const Joint& joint = design.joints[j];
    const std::size_t a = depth[static_cast<std::size_t>(joint.part_a)];
    const std::size_t b = depth[static_cast<std::size_t>(joint.part_b)];
    if (a == design.parts.size() || b == design.parts.size()) continue;  // not on the root's spool
    const bool a_is_near = a < b;
    JointBranch branch;
    branch.joint = static_cast<int>(j);
    branch.part_near = a_is_near ? joint.part_a : joint.part_b;
    branch.part_far = a_is_near ? joint.part_b : joint.part_a;
    branch.parts = reached(design, branch.part_far, branch.joint);
    branch.is_part.assign(design.parts.size(), 0);
    for (const int part : branch.parts) branch.is_part[static_cast<std::size_t>(part)] = 1;
    if (branch.holds(root)) continue;  // a loop: it hangs on something else as well
    const Part& near = design.parts[static_cast<std::size_t>(branch.part_near)];
    const Port& port =
        near.ports[static_cast<std::size_t>(a_is_near ? joint.port_a : joint.port_b)];
    branch.point = (near.T_design_part * port.position).cast<float>();
    branch.outward = (near.T_design_part.linear() * port.direction).normalized().cast<float>();
    tree.push_back(std::move(branch));
  }
  return tree;
}

}  // namespace spool
