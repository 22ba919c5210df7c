#version 300 es
// A corner of a panel: pixels of the screen, y down.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(location = 0) in vec2 a_position;
layout(location = 1) in vec2 a_texture;
layout(location = 2) in vec4 a_colour;

uniform vec2 u_origin;  // top left of the screen
uniform vec2 u_size;
out vec2 v_texture;
out vec4 v_colour;

void main() {
  v_texture = a_texture;
  v_colour = a_colour;
  vec2 at = 2.0 * (a_position - u_origin) / u_size - 1.0;
  gl_Position = vec4(at.x, -at.y, 0.0, 1.0);
}
