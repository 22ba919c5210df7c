#version 300 es
// Panels: the vertex colour times the texture, which is the font with a white pixel for plain areas.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_texture;
in vec4 v_colour;
uniform sampler2D u_texture;
out vec4 o_colour;

void main() { o_colour = v_colour * texture(u_texture, v_texture); }
