// The colour of a deviation: render/deviation_colour.h's stops, spaced evenly from the neutral band to the range.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
uniform vec3 u_inside_stops[9];   // sRGB; [0] is the neutral grey
uniform vec3 u_outside_stops[9];  // sRGB
uniform float u_neutral_m;        // m; half width of the grey band
uniform float u_range_m;          // m; the last colour, kept beyond it

vec3 deviation_colour(float deviation_m) {
  float along = 8.0 * clamp((abs(deviation_m) - u_neutral_m) / (u_range_m - u_neutral_m), 0.0, 1.0);
  int below = min(int(along), 7);
  float share = along - float(below);
  return deviation_m < 0.0 ? mix(u_inside_stops[below], u_inside_stops[below + 1], share)
                           : mix(u_outside_stops[below], u_outside_stops[below + 1], share);
}
