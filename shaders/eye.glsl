// From the design frame to clip space with the depth shifted along the line of sight.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
uniform mat4 u_eye_from_design;
uniform mat4 u_clip_from_eye;

// The clip position of an eye-frame point, at its own pixel, but as deep as if it stood `shift_m` farther away.
vec4 shifted_clip(vec3 p_eye, float shift_m) {
  vec4 clip = u_clip_from_eye * vec4(p_eye, 1.0);
  float distance_m = max(length(p_eye), 1e-4);
  vec4 shifted = u_clip_from_eye * vec4(p_eye * max(1.0 + shift_m / distance_m, 0.05), 1.0);
  clip.z = shifted.z / shifted.w * clip.w;
  return clip;
}
