// What a reading's noise is worth along the normal of the surface it fell on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/reading_noise.h"

#include <algorithm>
#include <cmath>

namespace spool {

ReadingNoise::ReadingNoise(const NoiseModel& model, const Camera& camera)
    : table_(kDepths, kCosines) {
  const double rounding2 = camera.depth_unit_m * camera.depth_unit_m / 12;
  // Lateral noise is of the sensor's own pixels; a thinned image has wider ones.
  constexpr double kSensorFocalPx = 575;  // ARCHITECTURE, The sensor
  const double focal = std::max(kSensorFocalPx, std::max(camera.fx, camera.fy));
  for (int row = 0; row < kDepths; ++row)
    for (int column = 0; column < kCosines; ++column) {
      const double z = (row + 0.5) * double{kStep};
      const double cosine = (column + 0.5) / kCosines;
      const double incidence = std::acos(cosine);
      const double axial = model.axial_m(z, incidence);
      const double lateral = model.lateral_m(z, incidence, focal);
      const double along = axial * axial * cosine * cosine;
      const double across = lateral * lateral * (1 - cosine * cosine);
      table_(row, column) = static_cast<float>(along + across + rounding2 * cosine * cosine);
    }
}

double correlated_readings(const Camera& camera, double step_px) {
  // Neighbours within so wide an angle share a correlation window: 8 px of a 575 px lens.
  constexpr double kWindowRad = 8.0 / 575;
  const double window_px = kWindowRad * std::min(camera.fx, camera.fy);
  return std::max(1.0, window_px * window_px / (step_px * step_px));
}

}  // namespace spool
