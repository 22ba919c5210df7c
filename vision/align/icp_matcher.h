// Correspondences of ICP: which scan points are near the design, and what each is compared to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vision/align/icp.h"

namespace spool {

// Points by place in the scan.
using Indices = std::vector<std::uint32_t>;

// Finite points nearer than `reach` (m) to the surface at pose T, in an order in which searches
// find what they need in the cache still (spatial_order.h).
[[nodiscard]] Indices near_points(const CloudView& scan, const DesignSurface& surface,
                                  const Pose& T, float reach, const Watch& watch);

// About `count` of them, evenly strewn whatever order the scan is in: those whose hash is least.
[[nodiscard]] Indices strewn(const Indices& all, std::size_t count);

// Compares scan points to the surface round after round, each remembering what lay round it.
class Matcher {
 public:
  // All borrowed.
  Matcher(const CloudView& scan, const DesignSurface& surface, const IcpOptions& options)
      : scan_(scan), surface_(surface), options_(options) {}

  // The points of the rounds that follow. `coarsely`: compared to the nearest element's plane,
  // which is as good while the gate is far wider than the surface's sampling, and not remembered.
  void choose(const Indices& indices, bool coarsely);
  // Compares the chosen points at pose T; those beyond the gate (m), off an edge or facing
  // elsewhere get weight 0, the rest weight 1. `margin` (m): as far as the points may move until
  // the next round with no new search; 0: further than is worth remembering for. Cancelled,
  // `matches` says nothing.
  void match(const Pose& T, double gate, double margin, const Watch& watch,
             std::vector<Correspondence>& matches);

 private:
  const CloudView& scan_;
  const DesignSurface& surface_;
  const IcpOptions& options_;
  // Of the chosen, side by side.
  std::vector<Eigen::Vector3f> points_, normals_;
  bool coarsely_ = false;
  std::vector<SurfaceMemory> memories_;  // empty where coarse or too many
};

}  // namespace spool
