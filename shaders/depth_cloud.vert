#version 300 es
// A pixel of a depth image as a point: its place in the design, its distance to it, the colour of that.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
precision highp int;
#include "deviation_colour.glsl"
#include "distance_volume.glsl"

uniform highp usampler2D u_depth;   // counts, row 0 at the top; 0: no measurement
uniform float u_depth_unit_m;       // of one count
uniform vec2 u_focal_px;            // of the depth camera
uniform vec2 u_centre_px;
uniform mat4 u_design_from_camera;  // x right, y down, z forward
uniform mat4 u_clip_from_design;
uniform float u_size_px;
uniform float u_spacing_px_m;       // px m: size at 1 m that closes the gaps between points, or 0
uniform float u_largest_px;         // what the driver draws
uniform float u_facing_beyond_m;    // further from the surface it has to face the camera
uniform float u_facing_cosine;      // to the line of sight, at least
uniform vec3 u_clutter_colour;      // sRGB
uniform bool u_show_clutter;
out vec3 v_colour;

void main() {
  int columns = textureSize(u_depth, 0).x;
  ivec2 pixel = ivec2(gl_VertexID % columns, gl_VertexID / columns);
  float z_m = u_depth_unit_m * float(texelFetch(u_depth, pixel, 0).r);
  vec3 p_camera = vec3((vec2(pixel) - u_centre_px) / u_focal_px * z_m, z_m);
  vec3 p_design = (u_design_from_camera * vec4(p_camera, 1.0)).xyz;

  VolumeCell cell = volume_cell(p_design);
  float distance_m;
  bool is_object = volume_distance(cell, distance_m);
  if (is_object && abs(distance_m) > u_facing_beyond_m) {
    vec3 outward = volume_outward(cell);
    vec3 to_eye = u_design_from_camera[3].xyz - (p_design - distance_m * outward);
    is_object = dot(outward, to_eye) >= u_facing_cosine * length(to_eye);
  }
  v_colour = is_object ? deviation_colour(distance_m) : u_clutter_colour;

  bool is_drawn = z_m > 0.0 && (is_object || u_show_clutter);
  gl_Position = is_drawn ? u_clip_from_design * vec4(p_design, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);  // behind all
  gl_PointSize = min(max(u_size_px, u_spacing_px_m / max(gl_Position.w, 1e-3)), u_largest_px);
}
