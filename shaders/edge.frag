#version 300 es
// One edge of the design with soft sides and a dark rim, so that it shows on light points and dark ground.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in float v_across;
flat in float v_lit;
uniform float u_width_px;
uniform float u_opacity;
uniform float u_lit_opacity;
uniform vec3 u_colour;      // sRGB
uniform vec3 u_lit_colour;  // sRGB
uniform vec3 u_rim_colour;  // sRGB
out vec4 o_colour;

void main() {
  float half_px = 0.5 * u_width_px + 0.5 * v_lit;
  float line = clamp(half_px + 0.5 - abs(v_across), 0.0, 1.0);
  float rim = 0.45 * clamp(half_px + 1.5 - abs(v_across), 0.0, 1.0);
  float cover = max(line, rim);
  if (cover <= 0.0) discard;
  vec3 colour = mix(u_rim_colour, mix(u_colour, u_lit_colour, v_lit), line / cover);
  o_colour = vec4(colour, cover * mix(u_opacity, u_lit_opacity, v_lit));
}
