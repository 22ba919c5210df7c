// Sizes of pipe, butt-weld fittings and class 150 flanges, NPS 2 to 8, typed from the standards.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace spool::campaign {

// All metres but the count. ASME B36.10M (pipe, wall STD), B16.9 (fittings), B16.5 class 150
// (flanges, inch edition: lengths and thicknesses include the raised face).
struct StandardSizes {
  double nps = 0;  // inches
  double outside_diameter = 0, wall = 0;
  double elbow_90 = 0;  // centre to end of the long-radius elbow, which is its bend radius too
  double elbow_45 = 0;  // centre to end
  double tee = 0;       // centre to end, run and outlet alike
  double cap = 0;       // length
  double reducer = 0;   // length, of the larger end
  double flange_diameter = 0, flange_thickness = 0;
  double raised_face = 0, bolt_circle = 0;  // diameters
  int holes = 0;
  double hole = 0, hub = 0;  // diameters; the hub's at its base
  double weld_neck = 0;      // face to weld end
};

inline constexpr double kRaisedFaceHeight = 0.0016;  // m, 1/16 inch

[[nodiscard]] std::span<const StandardSizes> standard_sizes();

// The row of a size; it must be one of the table's.
[[nodiscard]] const StandardSizes& sizes_of(double nps);

// Centre to end (m) of the outlet of a tee (B16.9); the run keeps its own.
[[nodiscard]] double tee_outlet(double nps, double nps2);

}  // namespace spool::campaign
