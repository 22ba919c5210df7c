// Loop closure: a frame that sees old pieces of the map beside new ones tells what was drifted
// between.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/loop_closure.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace spool {
namespace {

constexpr double kMajority = 0.5;
constexpr double kWorth = 25;         // variances: what is known five times worse than a fit tells
constexpr std::size_t kFewest = 300;  // facets of the view: a hundredth of it

// How many times the variance `own` the variance `other` is, in the motion where it is most.
double most_ratio(const Matrix6d& other, const Matrix6d& own) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(other, own,
                                                                  Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[5];
}

MapFit fit_part(const FrameSamples& frame, const Camera& camera, const ScanMap& map,
                const std::vector<bool>& of, const Pose& T_map_guess) {
  return fit_to_map(frame, MapViews::from(map, camera, T_map_guess, of), T_map_guess, true);
}

}  // namespace

std::optional<LoopCandidate> find_loop(const MapView& view, const Keyframes& keyframes,
                                       const Pose& T_map_camera, const Matrix6d& covariance) {
  const PoseGraph& graph = keyframes.graph();
  std::vector<std::size_t> seen(graph.size(), 0);
  for (int v = 0; v < view.camera().height; ++v)
    for (int u = 0; u < view.camera().width; ++u) {
      const MapFacet& facet = view.at(u, v);
      if (facet.size > 0) ++seen[facet.keyframe];
    }
  std::vector<std::size_t> in_view;
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (seen[k] > 0) in_view.push_back(k);
  if (in_view.size() < 2) return std::nullopt;

  LoopCandidate candidate;
  candidate.new_keyframe = keyframes.current();
  const std::vector<Matrix6d> apart = graph.covariances_from(candidate.new_keyframe, in_view);
  const Matrix6d own = in_axes_of(T_map_camera.linear(), step_covariance(covariance));
  candidate.old_ones.assign(graph.size(), false);
  candidate.new_ones.assign(graph.size(), false);
  std::size_t old_facets = 0, new_facets = 0, most_old = 0;
  for (std::size_t i = 0; i < in_view.size(); ++i) {
    const std::size_t k = in_view[i];
    const Matrix6d at_camera = small_seen_from(graph.T_map_keyframe(k).inverse() * T_map_camera);
    const bool is_old = most_ratio(at_camera * apart[i] * at_camera.transpose(), own) > kWorth;
    (is_old ? candidate.old_ones : candidate.new_ones)[k] = true;
    (is_old ? old_facets : new_facets) += seen[k];
    if (is_old && seen[k] > most_old) {
      most_old = seen[k];
      candidate.old_keyframe = k;
    }
  }
  if (old_facets < kFewest || new_facets < kFewest) return std::nullopt;
  return candidate;
}

std::optional<PoseEdge> measure_loop(const FrameSamples& frame, const Camera& camera,
                                     const LoopCandidate& candidate, const ScanMap& map,
                                     const Keyframes& keyframes, const Pose& T_map_camera) {
  const MapFit by_old = fit_part(frame, camera, map, candidate.old_ones, T_map_camera);
  if (by_old.share_low < kMajority) return std::nullopt;
  const MapFit by_new = fit_part(frame, camera, map, candidate.new_ones, T_map_camera);
  if (by_new.share_low < kMajority) return std::nullopt;
  const PoseGraph& graph = keyframes.graph();
  const Pose T_old_camera =
      graph.T_map_keyframe(candidate.old_keyframe).inverse() * by_old.T_map_camera;
  const Pose T_camera_new =
      by_new.T_map_camera.inverse() * graph.T_map_keyframe(candidate.new_keyframe);
  // Both parts were seen by other readings of the frame: their errors add.
  const Matrix6d carried = small_seen_from(T_camera_new);
  const Matrix6d both =
      in_axes_of(by_old.T_map_camera.linear(), step_covariance(by_old.covariance)) +
      in_axes_of(by_new.T_map_camera.linear(), step_covariance(by_new.covariance));
  return PoseEdge{candidate.old_keyframe, candidate.new_keyframe, T_old_camera * T_camera_new,
                  carried * both * carried.transpose()};
}

std::vector<Pose> close_loop(const PoseEdge& edge, Keyframes& keyframes, ScanMap& map) {
  PoseGraph& graph = keyframes.graph();
  std::vector<Pose> motions;
  if (!graph.close(edge)) return motions;
  motions.reserve(graph.size());
  for (std::size_t k = 0; k < graph.size(); ++k)
    motions.push_back(graph.T_map_keyframe(k).inverse());
  (void)graph.solve();
  for (std::size_t k = 0; k < graph.size(); ++k) motions[k] = graph.T_map_keyframe(k) * motions[k];
  map.move(motions);
  return motions;
}

}  // namespace spool
