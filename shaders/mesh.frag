#version 300 es
// The design's body as tinted glass: clear where it faces the eye, denser towards its outline.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec3 v_eye;
in vec3 v_normal;
flat in float v_lit;
uniform vec3 u_colour;      // sRGB
uniform vec3 u_lit_colour;  // sRGB
uniform float u_opacity;    // facing the eye
out vec4 o_colour;

void main() {
  vec3 to_eye = normalize(-v_eye);
  vec3 normal = normalize(v_normal);
  float facing = abs(dot(normal, to_eye));  // winding of foreign meshes is not relied on
  float rim = pow(1.0 - facing, 2.5);
  vec3 up_light = normalize(vec3(-0.3, 0.8, 0.5));
  float sky = 0.5 + 0.5 * dot(dot(normal, to_eye) < 0.0 ? -normal : normal, up_light);
  float light = 0.45 + 0.35 * facing + 0.25 * sky;
  vec3 colour = mix(u_colour, u_lit_colour, v_lit) * light;
  float opacity = min(u_opacity + 0.18 * v_lit, 1.0);
  o_colour = vec4(mix(colour, vec3(1.0), 0.25 * rim), mix(opacity, 0.85, rim));
}
