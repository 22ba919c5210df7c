// An order of visiting points along a Morton curve over a coarse grid.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/spatial_order.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include <Eigen/Geometry>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::uint32_t kBits = 6;  // of the grid, along each axis
constexpr std::uint32_t kCells = 1U << kBits;

// Whether points that follow each other mostly lie within a cell of the grid: what ordering gains
// is not to be had there. Some thousand pairs say so, whatever the cloud's size.
bool is_in_spatial_order(std::span<const Eigen::Vector3f> points,
                         std::span<const std::uint32_t> places, float cell_m) {
  const std::size_t step = places.size() / 1000 + 1;
  std::size_t near = 0, all = 0;
  for (std::size_t i = 1; i < places.size(); i += step, ++all)
    if ((points[places[i]] - points[places[i - 1]]).norm() <= cell_m) ++near;
  return 4 * near >= 3 * all;
}

// The bits of a cell's number along one axis, with room for the other two axes' between them.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t wide = 0;
  for (std::uint32_t i = 0; i < kBits; ++i) wide |= (bits >> i & 1U) << (3 * i);
  return wide;
}

}  // namespace

void put_in_spatial_order(std::span<const Eigen::Vector3f> points,
                          std::vector<std::uint32_t>& places, const Watch& watch) {
  Eigen::AlignedBox3f box;
  if (!watched_loop(places.size(), watch, [&](std::size_t i) { box.extend(points[places[i]]); }))
    return;
  if (box.isEmpty()) return;
  const float cell_m = box.sizes().maxCoeff() / static_cast<float>(kCells);
  if (!(cell_m > 0) || is_in_spatial_order(points, places, cell_m)) return;

  std::vector<std::uint32_t> spread_bits(kCells);
  for (std::uint32_t i = 0; i < kCells; ++i) spread_bits[i] = spread(i);
  // Not cleared first: of millions that alone would take longer than a cancel may.
  const auto key = std::make_unique_for_overwrite<std::uint32_t[]>(places.size());
  const auto ordered = std::make_unique_for_overwrite<std::uint32_t[]>(places.size());
  parallel_chunks(places.size(), 4096, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i) {
      key[i] = 0;
      const Eigen::Vector3f at = (points[places[i]] - box.min()) / cell_m;
      for (int axis = 0; axis < 3; ++axis) {
        const auto cell = std::min(static_cast<std::uint32_t>(at[axis]), kCells - 1);
        key[i] |= spread_bits[cell] << static_cast<std::uint32_t>(axis);
      }
    }
  });
  // A counting sort: few cells, and the given order stays inside each.
  std::vector<std::uint32_t> next(kCells * kCells * kCells + 1, 0);
  if (!watched_loop(places.size(), watch, [&](std::size_t i) { ++next[key[i] + 1]; })) return;
  std::partial_sum(next.begin(), next.end(), next.begin());
  if (!watched_loop(places.size(), watch,
                    [&](std::size_t i) { ordered[next[key[i]]++] = places[i]; }))
    return;
  std::copy_n(ordered.get(), places.size(), places.begin());
}

}  // namespace spool
