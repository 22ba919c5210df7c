// A design's joints as seen from one of their parts: own port, the neighbour and its port.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/joint_ends.h"

namespace spool::guide {

std::vector<std::vector<JointEnd>> joint_ends(const DesignModel& design) {
  std::vector<std::vector<JointEnd>> ends(design.parts.size());
  const auto is_there = [&](int part, int port) {
    return part >= 0 && part < static_cast<int>(design.parts.size()) && port >= 0 &&
           port < static_cast<int>(design.parts[static_cast<std::size_t>(part)].ports.size());
  };
  for (std::size_t j = 0; j < design.joints.size(); ++j) {
    const Joint& joint = design.joints[j];
    if (!is_there(joint.part_a, joint.port_a) || !is_there(joint.part_b, joint.port_b) ||
        joint.part_a == joint.part_b)
      continue;
    const int index = static_cast<int>(j);
    ends[static_cast<std::size_t>(joint.part_a)].push_back(
        {index, joint.port_a, joint.part_b, joint.port_b});
    ends[static_cast<std::size_t>(joint.part_b)].push_back(
        {index, joint.port_b, joint.part_a, joint.port_a});
  }
  return ends;
}

std::optional<JointEnd> at_port(const std::vector<JointEnd>& ends, int port) {
  for (const JointEnd& end : ends) {
    if (end.port == port) return end;
  }
  return std::nullopt;
}

PortPlace place_of(const Part& part, int port) {
  const Port& own = part.ports.at(static_cast<std::size_t>(port));
  return {part.T_design_part * own.position, part.T_design_part.linear() * own.direction};
}

int opposite_port(const Part& part, int port) {
  constexpr double kInLine = -0.999;  // cosine: 2.6 degrees, beyond any mitre that turns a run
  const Port& from = part.ports.at(static_cast<std::size_t>(port));
  int best = -1;
  double furthest = 0;
  for (std::size_t p = 0; p < part.ports.size(); ++p) {
    const double distance = (part.ports[p].position - from.position).norm();
    if (from.direction.dot(part.ports[p].direction) > kInLine || distance <= furthest) continue;
    best = static_cast<int>(p);
    furthest = distance;
  }
  return best;
}

}  // namespace spool::guide
