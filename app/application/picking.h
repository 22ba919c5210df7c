// What a tap on a picture means: the scan point or the design's surface under it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "render/view.h"
#include "vision/design/design_surface.h"
#include "vision/design/landmarks.h"

namespace spool {

// A tap may miss by this much and still mean a point: 1.5 mm of glass.
[[nodiscard]] double tap_slop_px(double dots_per_inch);

// The index of the point meant by a tap at (x, y) px of the picture: the nearest of the foremost
// surface right under the finger, else within `slop_px` (a tap on an edge means the steel, not the
// floor behind).
[[nodiscard]] std::optional<std::size_t> pick_point(std::span<const Eigen::Vector3f> points,
                                                    const render::View& view, double x, double y,
                                                    double slop_px);

// The design's surface under the tap, of a cloud design the point; beside the design the nearest
// landmark within the slop.
[[nodiscard]] std::optional<Landmark> pick_design(const DesignModel& design,
                                                  const DesignSurface& surface,
                                                  std::span<const Landmark> landmarks,
                                                  const render::View& view, double x, double y,
                                                  double slop_px);

}  // namespace spool
