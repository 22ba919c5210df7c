// A laser scanner's stations, merged and thinned to one spacing.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/campaign/ray_world.h"
#include "tools/campaign/sensed.h"

namespace spool::campaign {

struct LaserSettings {
  double noise_m = 0.003;  // standard deviation along the ray
  double station_error_m =
      0.0006;                     // of a station's registration: each axis, and 5 m away by turning
  double beam_radius_m = 0.0015;  // at the scanner
  double beam_spread_rad = 0.0001;
  std::vector<Eigen::Vector3d> stations = {};
};

// Points that a station sees, spread evenly over all that can be seen, as merged scans are after
// thinning (thesis 5: Poisson disks). Each lies off its surface by the noise along its ray and by
// its station's registration; where the beam grazes an edge with something further behind it, half
// of the points lie between the two (label kMixedPixel, clutter). Of the clutter what is nearest
// to `object` is kept, as if the scan were cropped round it, so that object and clutter have one
// spacing; where there is not enough clutter, it is taken more densely.
[[nodiscard]] std::vector<SensedPoint> scan_with_laser(const RayWorld& world,
                                                       const LaserSettings& settings,
                                                       const PointTargets& targets,
                                                       const Eigen::AlignedBox3d& object,
                                                       std::uint32_t seed);

// The area (m2) of the object's surface that some station sees.
[[nodiscard]] double seen_object_area(const RayWorld& world,
                                      const std::vector<Eigen::Vector3d>& stations,
                                      std::uint32_t seed);

}  // namespace spool::campaign
