// Some of a design's parts as geometry: samples, a few of them to probe with, and what holds them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/align/weak_directions.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/design/sampling.h"

namespace spool {

// The samples of the parts that are marked; `is_part`: one a part of the design.
[[nodiscard]] PointCloud samples_of(std::span<const std::uint8_t> is_part,
                                    const SurfaceSamples& all);

// What decides a motion that the piece's own surface hardly holds.
enum class HeldBy : std::uint8_t {
  kJoint,  // where the piece hangs as designed: the motion is none
  kShape,  // nothing else, where it hangs elsewhere: the little that the surface holds
};

struct PieceShape {
  PointCloud samples;                   // m, design frame, with normals
  std::vector<Eigen::Vector3f> probes;  // some of the samples, spread as they are
  NormalEquations equations;            // of points all over it
  HeldMotions motions;                  // that those hold

  PieceShape(std::span<const std::uint8_t> is_part, const SurfaceSamples& all);

  // `motion` (design frame, small) less what the piece's own surface hardly holds (not at all,
  // where nothing else decides): a pipe with a flange turns about its axis, its few bolt holes are
  // no hold; there the joint decides.
  [[nodiscard]] Pose as_held(const Pose& motion, HeldBy by = HeldBy::kJoint) const;
};

}  // namespace spool
