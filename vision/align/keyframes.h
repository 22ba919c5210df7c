// The keyframes that the pieces of a scan map hang on, and what that says of a camera that sees
// them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "vision/align/map_matcher.h"
#include "vision/align/pose_graph.h"
#include "vision/core/pose.h"
#include "vision/scan/scan_map.h"

namespace spool {

// A piece of the map goes with the frame that it was begun by. A frame that went on by 12 cm or 12
// degrees (as StoredViews has it) from all keyframes that it was fitted to is one itself, an edge
// of the graph away from the one that it shares most with. Where there are `most` of them the one
// that adds least is taken out, and its cells hang on its parent. One thread.
class Keyframes {
 public:
  explicit Keyframes(std::size_t most) : most_(most) {}

  [[nodiscard]] bool empty() const { return !graph_; }
  [[nodiscard]] PoseGraph& graph() { return *graph_; }
  [[nodiscard]] const PoseGraph& graph() const { return *graph_; }

  // The one that the newest cells hang on.
  [[nodiscard]] std::size_t current() const { return current_; }
  void set_current(std::size_t keyframe) { current_ = keyframe; }

  // The first frame of a map, whose frame is its camera's. Covariances here are of a small motion
  // about the camera in the axes of the map (as TrackedPose has them).
  void start(const Matrix6d& covariance);

  // What cells hang on that are started by a frame at T_map_camera, which was fitted to `shares`
  // with `covariance`. May rename keyframes, in the map too.
  [[nodiscard]] KeyframeId hang(const Pose& T_map_camera, std::span<const KeyframeShare> shares,
                                const Matrix6d& covariance, ScanMap& map);

  // What a camera is off by through what its frame was fitted to, the fit's own covariance left
  // out. The mean over the shares of what each keyframe is off by: the covariance of a weighted
  // mean is at most that, however its parts hang together.
  [[nodiscard]] Matrix6d covariance_at(const Pose& T_map_camera,
                                       std::span<const KeyframeShare> shares) const;

 private:
  [[nodiscard]] std::optional<KeyframeId> near(const Pose& T_map_camera,
                                               std::span<const KeyframeShare> shares) const;
  void make_room(ScanMap& map);

  std::size_t most_;
  std::optional<PoseGraph> graph_;
  std::size_t current_ = 0;
};

// What a new piece of the map is off by, against what its frame was fitted to, where that frame's
// fit has `covariance`: random errors average out over the frames that follow, but what all of them
// err by together gets into the map. Estimated, not derived: a map that a parked camera of
// spoolsight-track-campaign (seeds 1 and 2) builds ends up two standard deviations of one fit from
// where its first frame was, while the fits themselves scatter as they say.
[[nodiscard]] Matrix6d step_covariance(const Matrix6d& covariance);

// Turns a covariance about a camera from the axes of the map into the camera's own, or back with
// the inverse.
[[nodiscard]] Matrix6d in_axes_of(const Eigen::Matrix3d& R_map_camera, const Matrix6d& covariance);

}  // namespace spool
