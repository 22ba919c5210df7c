#version 300 es
// Lays a drawn layer over the picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
uniform sampler2D u_layer;
out vec4 o_colour;

void main() {
  vec4 colour = texelFetch(u_layer, ivec2(gl_FragCoord.xy), 0);
  if (colour.a == 0.0) discard;
  o_colour = colour;
}
