#version 300 es
// A glyph: its colour where the font covers the pixel.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_texture;
flat in vec4 v_colour;
uniform sampler2D u_font;
out vec4 o_colour;

void main() { o_colour = vec4(v_colour.rgb, v_colour.a * texture(u_font, v_texture).r); }
