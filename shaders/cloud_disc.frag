#version 300 es
// A measured point as a disc: for points so large that squares would show.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec3 v_colour;
out vec4 o_colour;

void main() {
  if (length(gl_PointCoord - 0.5) > 0.5) discard;
  o_colour = vec4(v_colour, 1.0);
}
