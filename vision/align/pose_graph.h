// A pose graph: keyframes' poses, what was measured between them, and how sure they are by it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "vision/core/pose.h"

namespace spool {

// What was measured between two keyframes. Covariances here are of a small motion (translation,
// rotation) of the camera `to` in its own axes, m and rad: T_from_to = measured * small.
struct PoseEdge {
  std::size_t from = 0, to = 0;
  Pose T_from_to = Pose::Identity();
  Matrix6d covariance = Matrix6d::Identity();
};

// The small motion that takes one pose to the other: b = a * pose_from_small(small).
[[nodiscard]] Vector6d small_between(const Pose& a, const Pose& b);

// How a small motion in a camera's own axes moves what is rigidly at T_camera_there, in that one's
// axes (the adjoint of the inverse).
[[nodiscard]] Matrix6d small_seen_from(const Pose& T_camera_there);

// Of so many degrees of freedom as a pose has, what chance exceeds once in a thousand times.
inline constexpr double kChiSquare6At999 = 22.46;

// Poses in one map frame. Odometry edges add keyframes, loop edges are added between those that are
// there; solve() is Gauss-Newton over all of them (Grisetti et al., "A Tutorial on Graph-Based
// SLAM", 2010). Odometry edges are taken to err independently; loops between the same two places
// err together, so that all of them count as one (covariance intersection with equal weights,
// Julier and Uhlmann 1997). One thread.
class PoseGraph {
 public:
  // `covariance`: of the first keyframe, against what the map frame means.
  PoseGraph(const Pose& T_map_first, const Matrix6d& covariance);
  ~PoseGraph();
  PoseGraph(PoseGraph&&) noexcept;
  PoseGraph& operator=(PoseGraph&&) noexcept;

  // A keyframe known by an odometry edge. Its index is the number of keyframes before it.
  std::size_t add(std::size_t from, const Pose& T_from_to, const Matrix6d& covariance);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t edge_count() const;
  [[nodiscard]] const Pose& T_map_keyframe(std::size_t i) const;
  // Of keyframe i's pose, in its own axes.
  [[nodiscard]] const Matrix6d& covariance(std::size_t i) const;
  // Of each pose of `others` as seen from keyframe `from`, as a PoseEdge would have it.
  [[nodiscard]] std::vector<Matrix6d> covariances_from(std::size_t from,
                                                       std::span<const std::size_t> others) const;

  // How far a measurement between two keyframes is from what the graph predicts, in the metric of
  // both covariances: chi-square of six degrees of freedom where it is right.
  [[nodiscard]] double chi_square(const PoseEdge& edge) const;
  // Takes the edge in, unless chance exceeds its chi_square() less than once in a thousand times:
  // then it is the same place in looks only. Poses stay until solve().
  bool close(const PoseEdge& edge);
  // Moves all poses to where they fit the edges best. The sum of squared normalised residuals.
  double solve();

  // Takes a keyframe out, but the first: its neighbours hang on the one it came from, by edges of
  // the same information one after the other. The last keyframe has its index afterwards. Gives the
  // keyframe it came from, by its index afterwards.
  std::size_t take_out(std::size_t i);
  // Where keyframe i came from; the first: itself.
  [[nodiscard]] std::size_t parent(std::size_t i) const;
  // What was added between it and its parent, as covariance.
  [[nodiscard]] const Matrix6d& step_covariance(std::size_t i) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spool
