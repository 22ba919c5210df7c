// How far a depth reading may be off at random, by range and incidence (ARCHITECTURE, The sensor).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/noise_model.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace spool {
namespace {

constexpr double kGrazing = std::numbers::pi / 2;

}  // namespace

// Nguyen, Izadi & Lovell 2012: 0.0012 + 0.0019 (z - 0.4)^2 + 0.0001 / sqrt(z) * t^2 / (pi/2 - t)^2.
double NoiseModel::axial_m(double z_m, double incidence_rad) const {
  if (constant_m > 0) return constant_m;
  assert(z_m > 0 && incidence_rad >= 0 && incidence_rad < kGrazing && "in front of the camera");
  const double tilt = incidence_rad / (kGrazing - incidence_rad);
  return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4) + 0.0001 / std::sqrt(z_m) * tilt * tilt;
}

// The same paper: 0.8 + 0.035 t / (pi/2 - t) pixels; a pixel is z / f metres wide.
double NoiseModel::lateral_m(double z_m, double incidence_rad, double focal_px) const {
  if (constant_m > 0) return constant_m;
  assert(z_m > 0 && incidence_rad >= 0 && incidence_rad < kGrazing && focal_px > 0 &&
         "in front of the camera");
  const double sigma_px = 0.8 + 0.035 * incidence_rad / (kGrazing - incidence_rad);
  return sigma_px * z_m / focal_px;
}

}  // namespace spool
