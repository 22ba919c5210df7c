// The two flanges' spool with bolt holes: in its drawing, and cut out of its scan by their circles.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tests/vision/measure/two_flange_spool.h"

namespace spool::test {

// Both flanges have `count` holes of 19 mm on a circle of 190.5 mm (ASME B16.5, NPS 4) that
// straddle x of their frames; z of flange A's is the design's, of flange B's the design's x.
[[nodiscard]] DesignModel holed_spool(int count);

struct HoledScan {
  SpoolScan spool;
  int count = 8;
  double hole_m = 0.019;  // diameter; 0: none were drilled
  double turn_a_rad = 0,
         turn_b_rad = 0;  // of the holes, right-handed about z of the flange's frame
};
[[nodiscard]] PointCloud scan_of_holed(const HoledScan& built, std::uint32_t seed);

// Fits features and holes to a scan in the design frame.
[[nodiscard]] PartFeatures holed_features(const DesignModel& design, const PointCloud& scan);

// How far (rad) the holes of a flange were read to be turned about its z, where they were.
[[nodiscard]] std::optional<double> turn_read(const PartFeatures& features, int part);

}  // namespace spool::test
