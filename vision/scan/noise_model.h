// How far a depth reading may be off at random, by range and incidence (ARCHITECTURE, The sensor).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spool {

// Axial and lateral standard deviations of a PrimeSense-class sensor (Nguyen, Izadi & Lovell 2012),
// or a constant for a laser-like cloud.
struct NoiseModel {
  double constant_m = 0.0;  // m; over 0: this everywhere (a cloud file), in place of the formula

  // Standard deviation along the ray (m) at depth z (m) and incidence angle (rad, 0 = head on).
  [[nodiscard]] double axial_m(double z_m, double incidence_rad = 0.0) const;
  // Standard deviation across the ray (m); focal length in px.
  [[nodiscard]] double lateral_m(double z_m, double incidence_rad, double focal_px) const;
};

}  // namespace spool
