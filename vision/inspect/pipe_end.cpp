// The surface that a pipe would have beyond its end, were it too long.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/pipe_end.h"

#include <algorithm>
#include <cmath>

namespace spool {

std::vector<PipeEndPoint> pipe_end(const DesignModel& design, const JointBranch& branch,
                                   const SurfaceSamples& samples) {
  std::vector<PipeEndPoint> end;
  for (const int part : {branch.part_near, branch.part_far}) {
    if (design.parts[static_cast<std::size_t>(part)].kind != PartKind::kPipe) continue;
    for (std::size_t s = 0; s < samples.part.size(); ++s) {
      if (samples.part[s] != part) continue;
      const Eigen::Vector3f& p = samples.cloud.points[s];
      const float along = (p - branch.frame.point).dot(branch.frame.outward);
      const float mirrored = part == branch.part_near ? 2 * along : 0;
      end.push_back({p - mirrored * branch.frame.outward, std::abs(along)});
    }
    break;
  }
  std::stable_sort(end.begin(), end.end(),
                   [](const PipeEndPoint& a, const PipeEndPoint& b) { return a.along < b.along; });
  return end;
}

}  // namespace spool
