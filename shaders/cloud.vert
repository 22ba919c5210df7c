#version 300 es
// A measured point: its place, its size, and for points of the object the colour of its deviation.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
#include "deviation_colour.glsl"
layout(location = 0) in vec4 a_point;  // m in the design frame; w: deviation, m

uniform mat4 u_clip_from_design;
uniform float u_size_px;
uniform float u_spacing_px_m;     // px m: size at 1 m that closes the gaps between points, or 0
uniform float u_largest_px;       // what the driver draws
uniform float u_use_deviation;    // 1: colour by deviation, 0: u_colour
uniform vec3 u_colour;            // sRGB
out vec3 v_colour;

void main() {
  gl_Position = u_clip_from_design * vec4(a_point.xyz, 1.0);
  gl_PointSize = min(max(u_size_px, u_spacing_px_m / max(gl_Position.w, 1e-3)), u_largest_px);
  v_colour = mix(u_colour, deviation_colour(a_point.w), u_use_deviation);
}
