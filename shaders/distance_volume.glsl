// The signed distance to the design, looked up in its volume: DistanceVolume::at() is the same arithmetic.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
uniform highp usampler3D u_grid;
uniform highp usampler3D u_nodes;
uniform highp sampler3D u_bricks;
uniform vec3 u_lowest_m;  // corner of the grid
uniform float u_cell_m;   // side of a grid cube
uniform float u_band_m;   // known so far from the surface

const uint kBlock = 1u;
const uint kBrick = 2u;

// A cell of a brick: its lowest texel, and the place within it, 0 to 1.
struct VolumeCell {
  bool is_known;
  vec3 texel;
  vec3 share;
};

VolumeCell volume_cell(vec3 point_m) {
  VolumeCell cell = VolumeCell(false, vec3(0.0), vec3(0.0));
  vec3 within = (point_m - u_lowest_m) / u_cell_m;
  ivec3 size = textureSize(u_grid, 0);
  if (any(lessThan(within, vec3(0.0))) || any(greaterThanEqual(within, vec3(size)))) return cell;
  ivec3 cube = ivec3(within);
  uint word = texelFetch(u_grid, cube, 0).r;
  within -= vec3(cube);
  for (int level = 0; level < 16 && word >> 24u == kBlock; ++level) {
    within *= 2.0;
    cube = min(ivec3(within), 1);
    within -= vec3(cube);
    word = texelFetch(u_nodes, 2 * ivec3(uvec3(word, word >> 8u, word >> 16u) & 255u) + cube, 0).r;
  }
  if (word >> 24u != kBrick) return cell;
  within *= 4.0;
  vec3 first = min(floor(within), 3.0);
  cell.is_known = true;
  cell.texel = 5.0 * vec3(uvec3(word, word >> 8u, word >> 16u) & 255u) + first;
  cell.share = within - first;
  return cell;
}

// Both distances of a brick at a place among its texels, m.
vec2 volume_distances(vec3 texel) {
  return textureLod(u_bricks, (texel + 0.5) / vec3(textureSize(u_bricks, 0)), 0.0).rg;
}

// Which of the two counts, as a factor of each.
vec2 lesser_of(vec2 distances) {
  return abs(distances.y) < abs(distances.x) ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
}

// Signed distance in m, + outside; false where the surface is further than u_band_m.
bool volume_distance(VolumeCell cell, out float distance_m) {
  distance_m = 0.0;
  if (!cell.is_known) return false;
  vec2 distances = volume_distances(cell.texel + cell.share);
  distance_m = dot(distances, lesser_of(distances));
  return abs(distance_m) <= u_band_m;
}

// Of the distance, of unit length. The difference of the cell's opposite faces is its slope within the cell.
vec3 volume_outward(VolumeCell cell) {
  vec3 at = cell.texel + cell.share;
  vec2 x = volume_distances(vec3(cell.texel.x + 1.0, at.yz)) - volume_distances(vec3(cell.texel.x, at.yz));
  vec2 y = volume_distances(vec3(at.x, cell.texel.y + 1.0, at.z)) -
           volume_distances(vec3(at.x, cell.texel.y, at.z));
  vec2 z = volume_distances(vec3(at.xy, cell.texel.z + 1.0)) - volume_distances(vec3(at.xy, cell.texel.z));
  vec2 counts = lesser_of(volume_distances(at));
  return normalize(vec3(dot(x, counts), dot(y, counts), dot(z, counts)));
}
