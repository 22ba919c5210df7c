// Some of a design's parts as geometry.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/piece_shape.h"

namespace spool {
namespace {

constexpr std::size_t kProbes = 200;
// Of the samples, seen head on: a motion of which less shows across the surface is hardly held.
// Bolt holes in a flange on a pipe come to up to 0.045, an elbow at the end of a long pipe to over
// 0.1.
constexpr double kHeldShare = 0.05;

}  // namespace

PointCloud samples_of(std::span<const std::uint8_t> is_part, const SurfaceSamples& all) {
  PointCloud some;
  for (std::size_t s = 0; s < all.part.size(); ++s) {
    if (is_part[static_cast<std::size_t>(all.part[s])] == 0) continue;
    some.points.push_back(all.cloud.points[s]);
    some.normals.push_back(all.cloud.normals[s]);
  }
  return some;
}

PieceShape::PieceShape(std::span<const std::uint8_t> is_part, const SurfaceSamples& all)
    : samples(samples_of(is_part, all)) {
  std::vector<Correspondence> matches;
  for (std::size_t s = 0; s < samples.size(); ++s)
    matches.push_back({samples.points[s], samples.normals[s], 0.0F, 1.0F});
  // Samples come in random order (Poisson disk): every nth is spread as they are.
  const std::size_t step = samples.size() / kProbes + 1;
  for (std::size_t s = 0; s < samples.size(); s += step) probes.push_back(samples.points[s]);
  equations = build_normal_equations(matches);
  motions = held_motions(equations, matches);
}

Pose PieceShape::as_held(const Pose& motion, HeldBy by) const {
  const Eigen::Vector3d& centre = equations.centre;
  Vector6d x;
  x << motion * centre - centre, rotation_vector(motion.linear());
  const double least = by == HeldBy::kJoint ? kHeldShare * static_cast<double>(samples.size()) : 0;
  for (int i = 0; i < 6; ++i) {
    if (!motions.weak[static_cast<std::size_t>(i)] && motions.held[i] >= least) continue;
    const Vector6d v = motions.directions.col(i);
    x -= v * v.dot(equations.mass * x);
  }
  Pose held = pose_from_small(x);
  held.translation() += centre - held.linear() * centre;
  return held;
}

}  // namespace spool
