#version 300 es
// A measured point as a small square: round ones cost a discard for a shape that nobody sees at 3 px.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec3 v_colour;
out vec4 o_colour;

void main() { o_colour = vec4(v_colour, 1.0); }
