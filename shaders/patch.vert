#version 300 es
// A mark of one patch of the design, flat on its surface: a strip of four vertices an instance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
#include "eye.glsl"
layout(location = 0) in vec3 a_position;  // m, design frame
layout(location = 1) in vec3 a_normal;    // unit, design frame
layout(location = 2) in float a_radius;   // m
layout(location = 3) in float a_sight;    // 0 not seen, 1 partly, 2 known

uniform float u_shift_m;
out vec2 v_at;  // -1 to 1 across the mark
flat out float v_sight;

void main() {
  v_sight = a_sight;
  v_at = vec2(gl_VertexID % 2 == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  vec3 middle = (u_eye_from_design * vec4(a_position, 1.0)).xyz;
  vec3 normal = mat3(u_eye_from_design) * a_normal;
  if (dot(normal, -middle) <= 0.0) {  // its back is seen: outside every plane
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 other = abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 across = normalize(cross(normal, other));
  vec3 along = cross(normal, across);
  gl_Position = shifted_clip(middle + a_radius * (v_at.x * across + v_at.y * along), u_shift_m);
}
