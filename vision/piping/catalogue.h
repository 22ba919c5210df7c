// The sizes of pipe, butt-weld fittings and flanges by nominal pipe size: ASME B36.10M, B16.9 and
// B16.5, as data.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "vision/core/result.h"

namespace spool::piping {

// Lengths are metres, sizes NPS in inches (0.5, 0.75, 1.25 ...). A size that no table holds is an
// Error (kBadInput) whose sentence names the size and what the table covers; nothing is
// interpolated.

// ASME B36.10M, NPS 1/8 to 24.
struct PipeSize {
  double nps = 0;
  int dn = 0;  // ISO 6708
  double outside_diameter = 0;
};
[[nodiscard]] std::span<const PipeSize> pipe_sizes();
[[nodiscard]] Result<PipeSize> pipe_size(double nps);

// Wall thickness by schedule: "STD" "XS" "XXS" "5S" to "80S", "10" to "160"; case and a leading
// "SCH" do not matter. 10S is B36.19M's.
[[nodiscard]] Result<double> wall_thickness(double nps, std::string_view schedule);

// ASME B16.9, NPS 1/2 to 24. Zero where the standard has no such fitting.
struct FittingSize {
  double nps = 0;
  double elbow_90_long = 0;   // centre to end, which is the bend radius too
  double elbow_90_short = 0;  // the same of the short radius
  double elbow_45 = 0;        // centre to end; the arc that closes it has the radius B / tan 22.5
  double tee = 0;             // centre to end, run and outlet of a straight tee
  double cap = 0;             // length, walls up to XS
  double reducer = 0;         // end to end, by the large end
};
[[nodiscard]] Result<FittingSize> fitting_size(double nps);

// Centre to end of a tee's outlet (M), straight or reducing; the run keeps FittingSize::tee.
[[nodiscard]] Result<double> tee_outlet(double nps, double branch_nps);

// ASME B16.5 class 150 and 300, NPS 1/2 to 24. Lengths and thicknesses include the raised face, as
// a fitter measures them: contact face to back, contact face to weld end.
struct FlangeSize {
  int rating = 0;
  double nps = 0;
  double outside_diameter = 0, thickness = 0;
  double raised_face = 0, bolt_circle = 0;  // diameters
  int holes = 0;
  double hole = 0, hub = 0;  // diameters; the hub's at its base
  double weld_neck = 0;      // contact face to weld end
  double slip_on = 0;        // length through the hub; threaded and socket weld flanges too
};
[[nodiscard]] Result<FlangeSize> flange_size(double nps, int rating);

inline constexpr double kRaisedFaceHeight = 0.0016;  // m, 1/16 inch, class 150 and 300
inline constexpr double kGasketThickness = 0.003;    // m, spiral wound, compressed

// The nominal pipe size whose outside diameter (m) this is, within `tolerance` (m): catalogues
// print 273.0 and 273.1. Nothing where there is none.
[[nodiscard]] std::optional<double> nps_of_outside_diameter(double diameter,
                                                            double tolerance = 0.0004);

// "1-1/2", "3/4", "10": a nominal size as it is written on drawings.
[[nodiscard]] std::string nps_text(double nps);

}  // namespace spool::piping
