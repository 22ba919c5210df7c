#version 300 es
// Darkens a point cloud where nearer points stand beside it, so that its form can be read without normals.
// Eye-dome lighting: C. Boucheny, Visualisation scientifique de grands volumes de donnees, 2009, 3.2.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
uniform highp sampler2D u_depth;
uniform float u_near_m;
uniform float u_far_m;
uniform float u_focal_px;
uniform float u_radius_px;  // at least: neighbours stand beyond the point's own square
uniform float u_spacing_m;  // m from point to point, or 0
uniform float u_strength;   // halvings of the light for a slope of 1
out vec4 o_colour;

// The inverse of the distance along the optical axis at one pixel, times near and far.
float nearness(ivec2 pixel) {
  return u_far_m - texelFetch(u_depth, pixel, 0).r * (u_far_m - u_near_m);
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(u_depth, here, 0).r;
  if (depth == 1.0) discard;
  float mine = u_far_m - depth * (u_far_m - u_near_m);
  float spacing_px = u_focal_px * u_spacing_m * mine / (u_near_m * u_far_m);
  int radius = int(clamp(0.8 * spacing_px, u_radius_px, 24.0) + 0.5);
  ivec2 last = textureSize(u_depth, 0) - 1;
  // By how much nearer each neighbour is, as a share of the distance: 1 - z' / z = 1 - mine / nearness'.
  vec4 beside = vec4(nearness(min(here + ivec2(radius, 0), last)),
                     nearness(max(here - ivec2(radius, 0), ivec2(0))),
                     nearness(min(here + ivec2(0, radius), last)),
                     nearness(max(here - ivec2(0, radius), ivec2(0))));
  vec4 nearer = max(vec4(0.0), 1.0 - mine / beside);
  // Depth over width: the surface's slope against the line of sight, whatever the picture's size.
  float slope = (nearer.x + nearer.y + nearer.z + nearer.w) * u_focal_px / float(radius);
  o_colour = vec4(vec3(max(exp2(-u_strength * slope), 0.45)), 1.0);
}
