// The scan as the search sees it: thinned, floor and walls set aside, elements at each level.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/find/dominant_planes.h"
#include "vision/find/elements.h"
#include "vision/find/finder_model.h"
#include "vision/find/occupancy.h"
#include "vision/find/outer_planes.h"
#include "vision/scan/point_index.h"
#include "vision/scan/sight.h"

namespace spool {

class FindScene {
 public:
  // `scan`: m, NaN allowed. `noise_m`: standard deviation of a point. `sight`: of a depth image,
  // null of any other scan; outlives this.
  FindScene(const FinderModel& model, std::span<const Eigen::Vector3f> scan, double noise_m,
            const Watch& watch, const Sight* sight = nullptr);

  [[nodiscard]] std::size_t finite() const { return finite_; }
  [[nodiscard]] bool was_thinned() const { return was_thinned_; }  // more than a search looks at
  [[nodiscard]] const std::vector<DominantPlane>& planes() const { return planes_; }
  [[nodiscard]] const std::vector<DominantPlane>& outer() const { return outer_; }
  [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
  [[nodiscard]] const PointIndex& index() const { return index_; }  // over points()
  [[nodiscard]] const Occupancy& occupancy() const { return occupancy_; }
  [[nodiscard]] const Sight* sight() const { return sight_; }
  // Worked out when first asked for. Not thread-safe.
  [[nodiscard]] const std::vector<Element>& elements(std::size_t level, const Watch& watch);

 private:
  const FinderModel& model_;
  const Sight* sight_;
  std::size_t finite_ = 0;
  bool was_thinned_ = false;
  std::vector<DominantPlane> planes_;
  std::vector<DominantPlane> outer_;     // of them, those that end the scan
  std::vector<Eigen::Vector3f> points_;  // off the planes, one a cell
  PointIndex index_;
  Occupancy occupancy_;
  std::vector<std::optional<std::vector<Element>>> elements_;
};

}  // namespace spool
