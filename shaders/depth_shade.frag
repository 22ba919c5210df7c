#version 300 es
// Darkens a point cloud where nearer points stand beside it, so that its form can be read without normals.
// Eye-dome lighting: C. Boucheny, Visualisation scientifique de grands volumes de donnees, 2009, 3.2.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_at;
uniform highp sampler2D u_depth;
uniform float u_near_m;
uniform float u_far_m;
uniform int u_radius_px;
uniform float u_strength;
out vec4 o_colour;

// log2 of the distance (m) along the optical axis at one pixel.
float log_distance(ivec2 pixel) {
  float depth = texelFetch(u_depth, pixel, 0).r;
  return log2(u_near_m * u_far_m / (u_far_m - depth * (u_far_m - u_near_m)));
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  if (texelFetch(u_depth, here, 0).r == 1.0) discard;
  ivec2 last = textureSize(u_depth, 0) - 1;
  float mine = log_distance(here);
  float nearer = 0.0;
  nearer += max(0.0, mine - log_distance(min(here + ivec2(u_radius_px, 0), last)));
  nearer += max(0.0, mine - log_distance(max(here - ivec2(u_radius_px, 0), ivec2(0))));
  nearer += max(0.0, mine - log_distance(min(here + ivec2(0, u_radius_px), last)));
  nearer += max(0.0, mine - log_distance(max(here - ivec2(0, u_radius_px), ivec2(0))));
  float light = exp2(-u_strength * 0.25 * nearer);
  o_colour = vec4(vec3(max(light, 0.35)), 1.0);
}
