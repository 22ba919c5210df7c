// What a branch fitting without ends of its own on the run sits on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/piping/run_of_branch.h"

#include <algorithm>

namespace spool::piping {
namespace {

constexpr double kOnAxis = 0.002;  // m

double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + share * along - p).norm();
}

double distance_to_axis(const Component& run, const Eigen::Vector3d& p) {
  if (!run.centre) return distance_to_segment(p, run.ends[0].position, run.ends[1].position);
  return std::min(distance_to_segment(p, run.ends[0].position, run.centre->position),
                  distance_to_segment(p, run.centre->position, run.ends[1].position));
}

}  // namespace

int run_of_branch(const Pipework& pipework, int fitting) {
  const Component& branch = pipework.components[static_cast<std::size_t>(fitting)];
  int best = -1;
  double nearest = kOnAxis;
  for (std::size_t c = 0; c < pipework.components.size(); ++c) {
    const Component& run = pipework.components[c];
    if (static_cast<int>(c) == fitting || !is_body(run) || run.ends.size() != 2) continue;
    // At a joint both axes end in one place: there a micrometre speaks for the pipe.
    const double penalty = run.kind == ComponentKind::kPipe ? 0 : 1e-6;
    const double distance = distance_to_axis(run, branch.centre->position) + penalty;
    if (distance > nearest) continue;
    nearest = distance;
    best = static_cast<int>(c);
  }
  return best;
}

}  // namespace spool::piping
