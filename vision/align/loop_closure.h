// Loop closure: a frame that sees old pieces of the map beside new ones tells what was drifted
// between.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "vision/align/frame_samples.h"
#include "vision/align/keyframes.h"
#include "vision/align/map_fit.h"

namespace spool {

// The pieces of the map in a view, parted by what the pose graph knows of their places.
struct LoopCandidate {
  std::size_t old_keyframe = 0;                    // of the old part the one that most is seen of
  std::size_t new_keyframe = 0;                    // the current one
  std::vector<bool> old_ones = {}, new_ones = {};  // by keyframe
};

// Whether a view at T_map_camera shows pieces that the graph tells apart five times worse, in some
// motion, than a fit with `covariance` (as TrackedPose has it) would: then a fit to each is worth
// its while. Nothing: all that is in view hangs together well enough.
[[nodiscard]] std::optional<LoopCandidate> find_loop(const MapView& view,
                                                     const Keyframes& keyframes,
                                                     const Pose& T_map_camera,
                                                     const Matrix6d& covariance);

// The frame fitted to the old part and to the new part alone, from T_map_camera; the edge between
// their keyframes. Nothing where one of the fits is not borne out by most of what it sees.
[[nodiscard]] std::optional<PoseEdge> measure_loop(const FrameSamples& frame, const Camera& camera,
                                                   const LoopCandidate& candidate,
                                                   const ScanMap& map, const Keyframes& keyframes,
                                                   const Pose& T_map_camera);

// Takes the edge into the graph and moves the map with its keyframes. Motions of the pieces by
// keyframe, in the map frame; empty: the gate (PoseGraph::close) refused the edge, and nothing was
// moved.
[[nodiscard]] std::vector<Pose> close_loop(const PoseEdge& edge, Keyframes& keyframes,
                                           ScanMap& map);

}  // namespace spool
