#version 300 es
// The design's body as painted steel on paper: light from the upper left, darker where it turns away.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec3 v_eye;
in vec3 v_normal;
flat in float v_lit;
uniform vec3 u_colour;      // sRGB
uniform vec3 u_lit_colour;  // sRGB
out vec4 o_colour;

void main() {
  vec3 to_eye = normalize(-v_eye);
  vec3 normal = normalize(v_normal);
  normal = dot(normal, to_eye) < 0.0 ? -normal : normal;  // winding of foreign meshes is not relied on
  float lamp = max(dot(normal, normalize(vec3(-0.45, 0.75, 0.5))), 0.0);
  float light = 0.50 + 0.40 * lamp + 0.18 * dot(normal, to_eye);
  o_colour = vec4(mix(u_colour, u_lit_colour, v_lit) * light, 1.0);
}
