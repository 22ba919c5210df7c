#version 300 es
// One edge of the design as a ribbon of constant width on the picture: a strip of four vertices an instance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
#include "eye.glsl"
layout(location = 0) in vec3 a_from;  // m, design frame
layout(location = 1) in vec3 a_to;    // m, design frame
layout(location = 2) in float a_lit;

uniform vec2 u_picture_px;
uniform float u_width_px;
uniform float u_near_m;
uniform float u_shift_m;
out float v_across;  // px from the middle of the line
flat out float v_lit;

vec2 on_picture(vec4 clip) { return 0.5 * u_picture_px * clip.xy / clip.w; }

void main() {
  vec3 from = (u_eye_from_design * vec4(a_from, 1.0)).xyz;
  vec3 to = (u_eye_from_design * vec4(a_to, 1.0)).xyz;
  v_lit = a_lit;
  v_across = 0.0;
  float near_z = -1.01 * u_near_m;
  if (from.z > near_z && to.z > near_z) {  // behind the eye: outside every plane
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (from.z > near_z) from = mix(to, from, (near_z - to.z) / (from.z - to.z));
  if (to.z > near_z) to = mix(from, to, (near_z - from.z) / (to.z - from.z));
  vec4 clip_from = shifted_clip(from, u_shift_m);
  vec4 clip_to = shifted_clip(to, u_shift_m);

  vec2 direction = on_picture(clip_to) - on_picture(clip_from);
  float length_px = length(direction);
  direction = length_px > 1e-6 ? direction / length_px : vec2(1.0, 0.0);
  float half_px = 0.5 * u_width_px + 2.5;  // with the lit line's extra, the rim and the soft edge
  bool is_end = gl_VertexID == 1 || gl_VertexID == 3;
  float side = gl_VertexID >= 2 ? 1.0 : -1.0;
  vec4 clip = is_end ? clip_to : clip_from;
  // Lines overlap by a quarter of their width where they meet, so that an outline has no gaps.
  float over_px = (is_end ? 0.25 : -0.25) * u_width_px;
  vec2 offset = direction * over_px + vec2(-direction.y, direction.x) * (side * half_px);
  clip.xy += 2.0 * offset / u_picture_px * clip.w;
  gl_Position = clip;
  v_across = side * half_px;
}
