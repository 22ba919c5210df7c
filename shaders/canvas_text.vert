#version 300 es
// A glyph on the picture: a strip of four vertices an instance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(location = 0) in vec4 a_box;      // px, y down: left, top, right, bottom
layout(location = 1) in vec4 a_texture;  // the same in the font's texture, 0..1
layout(location = 2) in vec4 a_colour;   // sRGB, opacity

uniform vec2 u_picture_px;
out vec2 v_texture;
flat out vec4 v_colour;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 3 ? 1.0 : 0.0, gl_VertexID >= 2 ? 1.0 : 0.0);
  v_texture = mix(a_texture.xy, a_texture.zw, corner);
  v_colour = a_colour;
  vec2 ndc = 2.0 * mix(a_box.xy, a_box.zw, corner) / u_picture_px - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
