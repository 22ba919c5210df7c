#version 300 es
// The design's body.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
#include "eye.glsl"
layout(location = 0) in vec3 a_position;  // m, design frame
layout(location = 1) in vec3 a_normal;    // unit, design frame
layout(location = 2) in float a_part;     // -1: none

uniform float u_shift_m;
uniform vec2 u_lit_parts;  // -1: none
out vec3 v_eye;            // m, eye frame
out vec3 v_normal;         // eye frame
flat out float v_lit;      // 1: a vertex of a lit part
invariant gl_Position;

void main() {
  v_eye = (u_eye_from_design * vec4(a_position, 1.0)).xyz;
  v_normal = mat3(u_eye_from_design) * a_normal;
  v_lit = a_part >= 0.0 && any(lessThan(abs(u_lit_parts - a_part), vec2(0.5))) ? 1.0 : 0.0;
  gl_Position = shifted_clip(v_eye, u_shift_m);
}
