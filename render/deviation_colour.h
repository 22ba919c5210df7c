// The colours of deviations: diverging, safe for the colour-blind, even in lightness on both sides.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

namespace spool::render {

// sRGB in 0..1, evenly spaced from the end of the neutral band ([0], grey) to the end of the range.
inline constexpr int kDeviationStops = 9;
using DeviationStops = std::array<Eigen::Vector3f, kDeviationStops>;
[[nodiscard]] const DeviationStops& inside_stops();   // blue: material missing, deviation < 0
[[nodiscard]] const DeviationStops& outside_stops();  // red: material too far out, deviation > 0

// The colour of a finite deviation (m): grey within +-neutral_m, the last colour from +-range_m on.
// The shader of the points (deviation_colour.glsl) computes the same from the same stops.
[[nodiscard]] Eigen::Vector3f deviation_colour(double deviation_m, double neutral_m,
                                               double range_m);

// Colours that mean something else than a deviation; sRGB in 0..1.
[[nodiscard]] Eigen::Vector3f clutter_colour();        // not of the object
[[nodiscard]] Eigen::Vector3f unknown_colour();        // of the object, deviation not known
[[nodiscard]] Eigen::Vector3f contradicting_colour();  // contradicts the design

}  // namespace spool::render
