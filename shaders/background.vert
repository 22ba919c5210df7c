#version 300 es
// One triangle that covers the picture; no vertex attributes.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
out vec2 v_at;  // 0..1, y up

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  v_at = corner;
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
