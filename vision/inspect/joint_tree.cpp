// The design's joints as a tree from the datum outward.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/joint_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace spool {
namespace {

int root_of(const DesignModel& design) { return design.datums.empty() ? 0 : design.datums.front(); }

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

// The length (m) of the longer of two joined parts that are pipes, between their ports; of tubes
// and what else has none any length.
double pipe_at(const DesignModel& design, const Joint& joint) {
  double most = 0;
  bool is_fitted = true;
  for (const int p : {joint.part_a, joint.part_b}) {
    const Part& part = design.parts[static_cast<std::size_t>(p)];
    is_fitted = is_fitted && part.kind != PartKind::kOther && part.kind != PartKind::kStructure;
    if (part.kind != PartKind::kPipe) continue;
    for (const Port& a : part.ports)
      for (const Port& b : part.ports) most = std::max(most, (a.position - b.position).norm());
  }
  return is_fitted ? most : std::numeric_limits<double>::infinity();
}

bool is_nested(const JointBranch& a, const JointBranch& b) {
  return a.holds(b.part_far) || b.holds(a.part_far);
}

// All parts of the root's spool that the branches do not hold.
JointBranch without(const std::vector<int>& spool, const JointBranch& branch,
                    const JointBranch* second) {
  JointBranch rest;
  rest.joint = branch.joint;
  rest.part_near = branch.part_far;
  rest.part_far = branch.part_near;
  rest.frame = {branch.frame.point, -branch.frame.outward};
  rest.most_shorter_m = branch.most_shorter_m;
  rest.is_part.assign(branch.is_part.size(), 0);
  rest.parts.push_back(rest.part_far);
  for (const int part : spool) {
    if (branch.holds(part) || (second != nullptr && second->holds(part))) continue;
    rest.is_part[static_cast<std::size_t>(part)] = 1;
    if (part != rest.part_far) rest.parts.push_back(part);
  }
  return rest;
}

}  // namespace

std::vector<JointBranch> joint_tree(const DesignModel& design) {
  std::vector<JointBranch> tree;
  if (design.parts.empty()) return tree;
  const int root = root_of(design);
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
    branch.most_shorter_m = pipe_at(design, joint);
    const Part& near = design.parts[static_cast<std::size_t>(branch.part_near)];
    const Port& port =
        near.ports[static_cast<std::size_t>(a_is_near ? joint.port_a : joint.port_b)];
    branch.frame = {(near.T_design_part * port.position).cast<float>(),
                    (near.T_design_part.linear() * port.direction).normalized().cast<float>()};
    tree.push_back(std::move(branch));
  }
  for (JointBranch& branch : tree)
    for (const JointBranch& other : tree)
      if (other.joint != branch.joint && !branch.holds(other.part_far))
        branch.others.push_back({other.frame, other.joint});
  return tree;
}

std::vector<int> parts_between(std::span<const JointBranch> tree, int a, int b) {
  std::vector<int> parts = {a};
  const auto add = [&](int part) {
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  };
  // A joint lies on the way where one of the two hangs on it and the other does not.
  for (const JointBranch& branch : tree) {
    if (branch.holds(a) == branch.holds(b)) continue;
    add(branch.part_near);
    add(branch.part_far);
  }
  add(b);
  return parts;
}

std::vector<JointBranch> datum_sides(const DesignModel& design) {
  std::vector<JointBranch> sides;
  if (design.parts.empty()) return sides;
  const std::vector<JointBranch> tree = joint_tree(design);
  const std::vector<int> spool = reached(design, root_of(design), -1);
  for (const JointBranch& branch : tree) sides.push_back(without(spool, branch, nullptr));
  for (const JointBranch& a : tree)
    for (const JointBranch& b : tree) {
      if (a.joint == b.joint || a.part_near != b.part_near || is_nested(a, b)) continue;
      JointBranch rest = without(spool, a, &b);
      rest.turns = false;
      rest.others.push_back({{b.frame.point, -b.frame.outward}, b.joint});
      sides.push_back(std::move(rest));
    }
  return sides;
}

}  // namespace spool
