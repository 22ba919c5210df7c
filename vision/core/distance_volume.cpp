// The look-up in a volume of distances: shaders/distance_volume.glsl in C++.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/distance_volume.h"

#include <cmath>

namespace spool {
namespace {

constexpr std::uint32_t kKind = 0xFF000000U;

Eigen::Array3i place_of(std::uint32_t word) {
  return {static_cast<int>(word & 0xFFU), static_cast<int>(word >> 8U & 0xFFU),
          static_cast<int>(word >> 16U & 0xFFU)};
}

bool leads_to(std::uint32_t word, VolumeWord kind) {
  return (word & kKind) == static_cast<std::uint32_t>(kind);
}

using Pair = Eigen::Array2f;

}  // namespace

std::optional<DistanceVolume::Reading> DistanceVolume::at(const Eigen::Vector3f& point) const {
  Eigen::Array3f within = (point - lowest).array() / cell_m;
  if (!(within >= 0).all()) return std::nullopt;  // NaN too
  Eigen::Array3i cube = within.min(static_cast<float>(kLargestSide)).cast<int>();
  if (cube[0] >= grid.size[0] || cube[1] >= grid.size[1] || cube[2] >= grid.size[2])
    return std::nullopt;
  std::uint32_t word = grid.data[grid.place(cube[0], cube[1], cube[2])];
  within -= cube.cast<float>();
  for (int level = 0; level < kMostLevels && leads_to(word, VolumeWord::kBlock); ++level) {
    within *= 2;
    cube = within.cast<int>().min(1);
    within -= cube.cast<float>();
    const Eigen::Array3i node = 2 * place_of(word) + cube;
    word = nodes.data[nodes.place(node[0], node[1], node[2])];
  }
  if (!leads_to(word, VolumeWord::kBrick)) return std::nullopt;

  constexpr int kCells = kBrickTexels - 1;
  within *= kCells;
  const Eigen::Array3i first = within.cast<int>().min(kCells - 1);
  const Eigen::Array3f share = within - first.cast<float>();
  const Eigen::Array3i texel = kBrickTexels * place_of(word) + first;
  const auto value = [&](int x, int y, int z) -> Pair {
    const auto& both = bricks.data[bricks.place(texel[0] + x, texel[1] + y, texel[2] + z)];
    return {static_cast<float>(both[0]), static_cast<float>(both[1])};
  };
  const auto mix = [](const Pair& a, const Pair& b, float t) -> Pair { return a + t * (b - a); };
  // The cell's faces square to an axis, at the point's place on them: their difference is the
  // slope.
  std::array<std::array<Pair, 2>, 3> faces;
  for (int end = 0; end < 2; ++end) {
    const auto side = [&](int axis, int a, int b) {
      return axis == 0 ? value(end, a, b) : axis == 1 ? value(a, end, b) : value(a, b, end);
    };
    for (int axis = 0; axis < 3; ++axis) {
      const float s = share[axis == 0 ? 1 : 0];
      const float t = share[axis == 2 ? 1 : 2];
      faces[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)] =
          mix(mix(side(axis, 0, 0), side(axis, 1, 0), s),
              mix(side(axis, 0, 1), side(axis, 1, 1), s), t);
    }
  }
  const Pair distances = mix(faces[0][0], faces[0][1], share[0]);
  const int lesser = std::abs(distances[1]) < std::abs(distances[0]) ? 1 : 0;
  if (!(std::abs(distances[lesser]) <= band_m)) return std::nullopt;
  Reading reading;
  reading.distance_m = distances[lesser];
  for (std::size_t axis = 0; axis < 3; ++axis)
    reading.outward[static_cast<Eigen::Index>(axis)] =
        faces[axis][1][lesser] - faces[axis][0][lesser];
  reading.outward.normalize();
  return reading;
}

std::size_t DistanceVolume::brick_count() const {
  return bricks.data.size() / (kBrickTexels * kBrickTexels * kBrickTexels);
}

std::size_t DistanceVolume::bytes() const {
  return sizeof(std::uint32_t) * (grid.data.size() + nodes.data.size()) +
         2 * sizeof(Eigen::half) * bricks.data.size();
}

}  // namespace spool
