// What a step of the assembly is: the part, the joints it makes, its cut length and where it comes
// from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/assembly_step.h"

namespace spool::guide {

std::vector<AssemblyStep> assembly_steps(const DesignModel& design, const std::vector<int>& order,
                                         const GapPolicy& policy) {
  const auto ends = joint_ends(design);
  std::vector<bool> stands(design.parts.size(), false);
  std::vector<AssemblyStep> steps;
  for (const int part : order) {
    AssemblyStep step;
    step.part = part;
    step.cut = cut_length(design, ends, part, policy);
    for (const JointEnd& end : ends.at(static_cast<std::size_t>(part))) {
      if (!stands[static_cast<std::size_t>(end.neighbour)]) continue;
      const Joint& joint = design.joints[static_cast<std::size_t>(end.joint)];
      const PortPlace port =
          place_of(design.parts[static_cast<std::size_t>(end.neighbour)], end.neighbour_port);
      step.joints.push_back({end, joint.weld, joint.type, port.position, port.direction});
    }
    stands[static_cast<std::size_t>(part)] = true;
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace spool::guide
