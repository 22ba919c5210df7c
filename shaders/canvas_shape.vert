#version 300 es
// A flat shape on the picture: a strip of four vertices an instance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(location = 0) in vec4 a_box;      // px, y down: centre, half size
layout(location = 1) in vec4 a_form;     // corner radius px, border px, turn rad, 1: triangle
layout(location = 2) in vec4 a_fill;     // sRGB, opacity
layout(location = 3) in vec4 a_border;

uniform vec2 u_picture_px;
out vec2 v_at;  // px from the centre, in the shape's own axes
flat out vec2 v_half;
flat out vec4 v_form;
flat out vec4 v_fill;
flat out vec4 v_border;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 3 ? 1.0 : -1.0, gl_VertexID >= 2 ? 1.0 : -1.0);
  v_at = corner * (a_box.zw + 1.0);  // one pixel for the soft edge
  v_half = a_box.zw;
  v_form = a_form;
  v_fill = a_fill;
  v_border = a_border;
  float c = cos(a_form.z);
  float s = sin(a_form.z);
  vec2 at = a_box.xy + vec2(c * v_at.x - s * v_at.y, s * v_at.x + c * v_at.y);
  vec2 ndc = 2.0 * at / u_picture_px - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
