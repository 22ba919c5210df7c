#version 300 es
// A point that contradicts the design: larger than the others, so that its shape can be told.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(location = 0) in vec4 a_point;  // m in the design frame; w unused

uniform mat4 u_clip_from_design;
uniform float u_size_px;

void main() {
  gl_Position = u_clip_from_design * vec4(a_point.xyz, 1.0);
  gl_PointSize = u_size_px;
}
