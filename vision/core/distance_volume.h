// Signed distance to a surface as a volume that a graphics card can look up: three 3-D textures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace spool {

// A 3-D texture as it is uploaded: x runs fastest.
template <class T>
struct Texels {
  std::array<int, 3> size{};  // at most DistanceVolume::kLargestSide each
  std::vector<T> data;

  [[nodiscard]] std::size_t place(int x, int y, int z) const {
    return static_cast<std::size_t>((z * size[1] + y) * size[0] + x);
  }
};

// The words of grid and nodes: what kind of thing they lead to, and where it stands. A block is
// named by its place among blocks (its first node is at twice that), a brick by its place among
// bricks (its first texel is at kBrickTexels times that).
enum class VolumeWord : std::uint32_t { kNothing = 0, kBlock = 1U << 24U, kBrick = 2U << 24U };

[[nodiscard]] constexpr std::uint32_t volume_word(VolumeWord kind, std::uint32_t x, std::uint32_t y,
                                                  std::uint32_t z) {
  return static_cast<std::uint32_t>(kind) | z << 16U | y << 8U | x;
}

// A value; what is in it is read-only to all threads. A grid of cubes covers the design; each leads
// to nothing (the surface is further than `band_m` everywhere in it), to a brick, or to a block of
// eight nodes for its eighths, and so on. A brick is 5 x 5 x 5 texels over its cube, border
// included, each two distances in half floats: to the nearer and to the other of two pieces of
// surface, each as if it were alone, so that interpolation rounds nothing off where two pieces are
// equally near (the middle of a plate, the corner between pipe and flange). The lesser is the
// distance. shaders/distance_volume.glsl is the same arithmetic.
struct DistanceVolume {
  static constexpr int kBrickTexels = 5;    // a side
  static constexpr int kLargestSide = 256;  // texels; every ES 3.0 driver takes so many
  static constexpr int kMostLevels = 16;    // of nodes under the grid

  Eigen::Vector3f lowest = Eigen::Vector3f::Zero();  // m, corner of the grid
  float cell_m = 0;                                  // side of a grid cube
  float band_m = 0;                                  // known so far from the surface
  Texels<std::uint32_t> grid;
  Texels<std::uint32_t> nodes;
  Texels<std::array<Eigen::half, 2>> bricks;  // m, + outside

  struct Reading {
    float distance_m = 0;  // + outside
    // Of the distance: the surface's normal at the nearest place, where that is not an edge.
    Eigen::Vector3f outward = Eigen::Vector3f::Zero();
  };
  // At a point in the frame of the volume (m); nothing where the surface is further than band_m.
  [[nodiscard]] std::optional<Reading> at(const Eigen::Vector3f& point) const;

  [[nodiscard]] std::size_t brick_count() const;
  [[nodiscard]] std::size_t bytes() const;  // of the three textures
};

}  // namespace spool
