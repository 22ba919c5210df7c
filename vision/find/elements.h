// Points with a direction: the normal of a surface, or the axis of something long and thin.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"

namespace spool {

enum class ElementKind {
  kSurface,  // direction: the normal of a patch
  kTube,     // direction: the axis of a pipe or a bar; point: near that axis
};

// The sign of `direction` means nothing.
struct Element {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();      // m
  Eigen::Vector3f direction = Eigen::Vector3f::Zero();  // unit
};

// What a neighbourhood is, and when it is flat or long enough to have a direction.
struct ElementOptions {
  ElementKind kind = ElementKind::kSurface;
  double radius_m = 0.05;          // m; of the neighbourhood
  std::size_t min_neighbours = 7;  // fewer points have no direction worth having
};

// One element for each place of `points` (m, finite, about evenly thinned) whose neighbourhood has
// a direction: by the principal axes of its points (thesis 4.3.2). In the points' order.
[[nodiscard]] std::vector<Element> local_elements(std::span<const Eigen::Vector3f> points,
                                                  const ElementOptions& options,
                                                  const Watch& watch = {});

}  // namespace spool
