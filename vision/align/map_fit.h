// Fits a frame to the scan map from a guess, and says by the statistics of the fit what it is
// worth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "vision/align/frame_samples.h"
#include "vision/align/map_matcher.h"
#include "vision/align/weak_directions.h"
#include "vision/core/pose.h"
#include "vision/scan/map_view.h"

namespace spool {

// The map from one place, fine and coarse.
struct MapViews {
  MapView fine, coarse;

  // As the frame's camera would see it from there, or of some keyframes (MapView).
  [[nodiscard]] static MapViews from(const ScanMap& map, const Camera& camera,
                                     const Pose& T_map_view, const std::vector<bool>& of = {});
};

struct MapFit {
  Pose T_map_camera = Pose::Identity();
  // Of the small motion (translation, rotation) about the camera in the axes of the map, m and rad;
  // weak motions are left at 10 m.
  Matrix6d covariance = Matrix6d::Identity();
  std::vector<WeakDirection> weak_directions = {};
  std::size_t agrees = 0, contradicts = 0, in_front = 0;  // samples
  // Of the samples that would see a motion of the camera, the share that agrees with its place, of
  // the held motion where that is least; and what it may be, by chance of so many samples.
  double share = 0, share_low = 0, share_high = 0;
  std::vector<KeyframeShare> shares = {};  // what pieces of the map it was fitted to
  double spread = 0;  // RMS of the agreeing residuals over their standard deviations; about 1
};

// Point-to-plane in the motions that the matches hold; the others stay as guessed (Zhang & Singh
// 2016). `is_near`: the guess is good to about a cell; else it is first looked for coarsely, some
// 10 cm or 10 degrees round the guess. `views` must be from about the guess.
[[nodiscard]] MapFit fit_to_map(const FrameSamples& frame, const MapViews& views,
                                const Pose& T_map_guess, bool is_near);

// Mean of the samples' squared normalised residuals, cut at 9 and 9 where none is near: which of
// two guesses is the better one. A coarse look at a tenth of the samples.
[[nodiscard]] double guess_cost(const FrameSamples& frame, const MapView& view,
                                const Pose& T_map_camera);

}  // namespace spool
