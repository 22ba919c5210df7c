// Readings that cannot be of the face they are compared with: it is turned away from the sensor.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Eigen/Core>

#include "vision/core/cloud_view.h"
#include "vision/design/design_surface.h"
#include "vision/inspect/declutter.h"
#include "vision/inspect/deviation.h"

namespace spool {

// Nearer than so many standard deviations of a point to the surface, noise may have put a reading
// round an edge.
inline constexpr double kFacingSigmas = 3.0;
// Cosine to the line of sight under which a depth sensor gives next to nothing (DOMAIN 6: 80
// degrees).
inline constexpr double kFacingCosine = 0.17;

// A floor close under a pipe is nearest to the pipe's underside, which a sensor above cannot see:
// such readings are of something else and become clutter (class and deviation). Only readings
// further than `beyond_m` from the surface are looked at: nearer ones may lie round an edge by
// noise. Points (m) and `eye`, the sensor's place, in the design frame. Gives how many there were.
std::size_t drop_turned_away(const CloudView& scan_design, const Eigen::Vector3d& eye,
                             const DesignSurface& surface, float beyond_m,
                             std::span<PointClass> classes, Deviations& deviations);

}  // namespace spool
