// Which facet of the map a frame's reading lies on, by projection into a view of the map.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vision/align/frame_samples.h"
#include "vision/align/weak_directions.h"
#include "vision/core/pose.h"
#include "vision/scan/map_view.h"

namespace spool {

// How far a match may be sought.
struct MatchReach {
  int window_px = 1;      // of the view, to each side of the pixel
  float gate_m = 0.01F;   // residuals beyond this and beyond the noise weigh nothing
  std::size_t every = 1;  // of the samples
};

// Matches of the samples taken (one each, weight 0 where there is none), for a camera at
// `T_map_camera`: nearest facet of the window that faces the same way. Points are about the view's
// eye, in the axes of the map frame; residuals along the mean of both normals, which is exact on
// round surfaces too (Rusinkiewicz 2019, symmetric ICP). Weights are Tukey's, of residuals over
// their own standard deviation, times the samples' median variance over theirs.
[[nodiscard]] std::vector<Correspondence> match_to_view(const FrameSamples& frame,
                                                        const MapView& view,
                                                        const Pose& T_map_camera,
                                                        const MatchReach& reach);

// How many samples lie on cells of a keyframe.
struct KeyframeShare {
  KeyframeId keyframe = 0;
  std::size_t samples = 0;
};

enum class Vouch : std::uint8_t {
  kUnknown,      // the map knows nothing there
  kAgrees,       // within three standard deviations of the surface that is expected
  kContradicts,  // another surface is expected there
  kInFront       // something stands before what is expected: a hand, or a wrong pose
};

// What every sample says of the pose. Residuals in the matches are set whatever the verdict, with
// weight 1 where it is not kUnknown.
struct Vouching {
  std::vector<Correspondence> matches = {};
  std::vector<Vouch> says = {};
  std::vector<KeyframeShare> shares = {};  // of those that agree, by number of the keyframe
  std::size_t agrees = 0, contradicts = 0, in_front = 0;
};
[[nodiscard]] Vouching vouch_for(const FrameSamples& frame, const MapView& view,
                                 const Pose& T_map_camera);

}  // namespace spool
