#version 300 es
// A hatched disc: told from other points by pattern as well as by colour, however close the points lie.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
uniform vec3 u_colour;       // sRGB
uniform vec3 u_hatch;        // sRGB
uniform float u_hatch_px;    // from stripe to stripe
out vec4 o_colour;

void main() {
  if (length(gl_PointCoord - 0.5) > 0.5) discard;
  float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / u_hatch_px);
  o_colour = vec4(stripe < 0.4 ? u_hatch : u_colour, 1.0);
}
