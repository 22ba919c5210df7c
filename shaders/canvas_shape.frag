#version 300 es
// A rounded box or a triangle with a border, its edge soft over one pixel by its signed distance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 v_at;
flat in vec2 v_half;
flat in vec4 v_form;
flat in vec4 v_fill;
flat in vec4 v_border;
out vec4 o_colour;

// Distance (px, inside negative) from a box with rounded corners.
float rounded_box(vec2 p, vec2 half_size, float radius) {
  vec2 q = abs(p) - half_size + radius;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
}

// Distance from a triangle: apex at the top middle of the box, base along its bottom.
float triangle(vec2 p, vec2 half_size) {
  vec2 side = normalize(vec2(2.0 * half_size.y, half_size.x));  // normal of the right side, y down: up is -
  float sides = dot(vec2(abs(p.x), p.y) - vec2(0.0, -half_size.y), vec2(side.x, -side.y));
  return max(sides, p.y - half_size.y);
}

void main() {
  float away = v_form.w > 0.5 ? triangle(v_at, v_half) : rounded_box(v_at, v_half, v_form.x);
  float cover = clamp(0.5 - away, 0.0, 1.0);
  float inner = clamp(0.5 - away - v_form.y, 0.0, 1.0);  // 1 inside the border
  vec4 border = v_form.y > 0.0 ? v_border : v_fill;
  float opacity = mix(border.a, v_fill.a, inner);
  vec3 colour = mix(border.rgb * border.a, v_fill.rgb * v_fill.a, inner) / max(opacity, 1e-4);
  o_colour = vec4(colour, opacity * cover);
}
