// The cut list: how long each pipe is sawn, from centre to centre less take-offs and root gaps.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/cut_list.h"

#include <cmath>
#include <map>
#include <utility>

#include "vision/piping/joint_graph.h"

namespace spool::piping {

double take_off(const Component& component, int port) {
  if (component.kind == ComponentKind::kPipe) return 0;
  const Eigen::Vector3d& from = port_of(component, port).position;
  if (component.centre) return (component.centre->position - from).norm();
  if (component.ends.size() != 2 || port > 1) return 0;
  const Eigen::Vector3d through =
      component.ends[static_cast<std::size_t>(1 - port)].position - from;
  const Eigen::Vector3d& outward = component.directions[static_cast<std::size_t>(port)];
  // Along the pipe: an eccentric reducer's ends do not lie in line.
  return outward.norm() > 0.5 ? std::abs(through.dot(outward)) : through.norm();
}

std::vector<CutPipe> cut_list(const Pipework& pipework, double root_gap) {
  std::map<std::pair<int, int>, const PipeJoint*> joints;  // by component and port
  for (const PipeJoint& joint : pipework.joints) {
    if (joint.port_a == kOnRun) continue;
    joints[{joint.a, joint.port_a}] = &joint;
    joints[{joint.b, joint.port_b}] = &joint;
  }
  std::vector<CutPipe> list;
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    const Component& pipe = pipework.components[c];
    if (pipe.kind != ComponentKind::kPipe || pipe.ends.size() != 2) continue;
    CutPipe cut;
    cut.component = static_cast<int>(c);
    cut.drawn = (pipe.ends[1].position - pipe.ends[0].position).norm();
    for (int p = 0; p < 2; ++p) {
      const auto found = joints.find({cut.component, p});
      if (found == joints.end()) continue;
      const PipeJoint& joint = *found->second;
      const bool is_a = joint.a == cut.component && joint.port_a == p;
      CutEnd& end = cut.ends[p];
      end.neighbour = is_a ? joint.b : joint.a;
      const Component& other = pipework.components[static_cast<std::size_t>(end.neighbour)];
      end.take_off = take_off(other, is_a ? joint.port_b : joint.port_a);
      const bool is_butt = joint.kind == PipeJoint::Kind::kWeld && joint.gap <= kMeets;
      if (is_butt) end.root_gap = other.kind == ComponentKind::kPipe ? root_gap / 2 : root_gap;
    }
    list.push_back(cut);
  }
  return list;
}

}  // namespace spool::piping
