// Is there a scan point near: one bit a cell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/occupancy.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace spool {
namespace {

constexpr double kCellsPerNear = 1.5;           // a cell is two thirds of what counts as near
constexpr std::size_t kMostBlocks = 1U << 25U;  // 128 MiB of block numbers: a hall at any size

}  // namespace

Occupancy::Occupancy(std::span<const Eigen::Vector3f> points, double near_m) {
  assert(near_m > 0 && "near is a distance");
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : points)
    if (point.allFinite()) box.extend(point);
  if (box.isEmpty()) return;
  double cell = near_m / kCellsPerNear;
  Eigen::Array3d blocks;
  for (;; cell *= 1.5) {  // coarser where the scan is kilometres wide
    blocks = ((box.sizes().cast<double>().array() + 4 * near_m) / (8 * cell)).ceil().max(1.0);
    if (blocks.prod() <= static_cast<double>(kMostBlocks)) break;
  }
  per_m_ = static_cast<float>(1.0 / cell);
  corner_ = box.min().array() - static_cast<float>(2 * near_m);
  size_x_ = static_cast<std::size_t>(blocks.x());
  size_y_ = static_cast<std::size_t>(blocks.y());
  size_z_ = static_cast<std::size_t>(blocks.z());
  size_f_ = (8 * blocks).cast<float>();
  blocks_.assign(size_x_ * size_y_ * size_z_, 0);
  // The cells whose middle is within near of the point's own cell's middle.
  const int wide = static_cast<int>(std::ceil(near_m / cell));
  std::vector<Eigen::Array3i> ball;
  for (int k = -wide; k <= wide; ++k)
    for (int j = -wide; j <= wide; ++j)
      for (int i = -wide; i <= wide; ++i)
        if (std::sqrt(static_cast<double>(i * i + j * j + k * k)) * cell <= near_m)
          ball.emplace_back(i, j, k);
  for (const Eigen::Vector3f& point : points) {
    if (!point.allFinite()) continue;
    const Eigen::Array3i at = ((point - corner_).array() * per_m_).cast<int>();
    for (const Eigen::Array3i& step : ball) set(at + step);
  }
}

void Occupancy::set(const Eigen::Array3i& cell) {
  const Eigen::Array3f cell_f = cell.cast<float>();
  if (!((cell >= 0).all() && (cell_f < size_f_).all())) return;
  const auto i = static_cast<std::uint32_t>(cell.x());
  const auto j = static_cast<std::uint32_t>(cell.y());
  const auto k = static_cast<std::uint32_t>(cell.z());
  std::uint32_t& block =
      blocks_[(std::size_t{k >> 3U} * size_y_ + (j >> 3U)) * size_x_ + (i >> 3U)];
  if (block == 0) {
    block = static_cast<std::uint32_t>(bits_.size() / 8);
    bits_.resize(bits_.size() + 8, 0);
  }
  bits_[std::size_t{block} * 8 + (k & 7U)] |= std::uint64_t{1} << ((j & 7U) * 8 + (i & 7U));
}

}  // namespace spool
