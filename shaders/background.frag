#version 300 es
// A soft vertical gradient behind everything.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_at;  // 0..1, y up
uniform vec3 u_top;     // sRGB
uniform vec3 u_bottom;  // sRGB
out vec4 o_colour;

void main() {
  vec3 colour = mix(u_bottom, u_top, smoothstep(0.0, 1.0, v_at.y));
  // Half a step of ordered noise hides the bands that eight bits leave in a dark gradient.
  float noise = fract(dot(floor(gl_FragCoord.xy), vec2(0.75487767, 0.56984029))) - 0.5;
  o_colour = vec4(colour + noise / 255.0, 1.0);
}
