#version 300 es
// A mark of one patch: a full disc where it is known, a ring where partly, a dashed ring where not seen.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_at;
flat in float v_sight;
uniform vec3 u_known;     // sRGB
uniform vec3 u_partly;    // sRGB
uniform vec3 u_not_seen;  // sRGB
out vec4 o_colour;

void main() {
  float r = length(v_at);
  float soft = max(fwidth(r), 1e-4);
  float inside = 1.0 - smoothstep(1.0 - soft, 1.0, r);
  if (v_sight > 1.5) {
    o_colour = vec4(u_known, inside * 0.92);
  } else if (v_sight > 0.5) {
    o_colour = vec4(u_partly, inside * smoothstep(0.55 - soft, 0.55, r));
  } else {
    float dash = step(0.0, sin(6.0 * atan(v_at.y, v_at.x)));  // six
    o_colour = vec4(u_not_seen, 0.9 * inside * dash * smoothstep(0.7 - soft, 0.7, r));
  }
  if (o_colour.a < 0.02) discard;
}
