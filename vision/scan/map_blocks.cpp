// Where the map's cells lie: cubes of 8 by 8 by 8 voxels, found by their place.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/map_blocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr int kSide = 8;             // voxels
constexpr int kHalfRange = 1 << 18;  // blocks each way: 16 km at the finest
constexpr float kSameSide = 0.5F;    // cosine

// No block, where the place is out of range.
constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

std::uint64_t key_of(const Eigen::Vector3f& point, float edge, int level) {
  std::uint64_t key = static_cast<std::uint64_t>(level);
  for (int axis = 0; axis < 3; ++axis) {
    const float at = std::floor(point[axis] / edge);
    if (!(std::abs(at) < static_cast<float>(kHalfRange))) return kNoKey;
    key = key << 19 | static_cast<std::uint64_t>(static_cast<std::int64_t>(at) + kHalfRange);
  }
  return key;
}

}  // namespace

std::size_t MapBlock::voxel_of(const Eigen::Vector3f& point) const {
  // Means wander a little out of their block; then the nearest voxel stands for theirs.
  const Eigen::Vector3f at = (point - corner) / voxel;
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis)
    index = index * kSide + static_cast<std::size_t>(
                                std::clamp(static_cast<int>(std::floor(at[axis])), 0, kSide - 1));
  return index;
}

void MapBlock::relink() {
  first.fill(-1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::int16_t& head = first[voxel_of(cells[i].mean)];
    cells[i].next = head;
    head = static_cast<std::int16_t>(i);
  }
}

bool MapBlocks::add(const MapCell& cell, int level) {
  const float voxel = std::ldexp(cell_m_, level);
  const float edge = kSide * voxel;
  const std::uint64_t key = key_of(cell.mean, edge, level);
  if (key == kNoKey) return false;
  const auto found = place_.find(key);
  std::uint32_t index = 0;
  if (found != place_.end()) {
    index = found->second;
  } else {
    if (free_.empty()) {
      index = static_cast<std::uint32_t>(blocks_.size());
      blocks_.emplace_back();
    } else {
      index = free_.back();
      free_.pop_back();
    }
    place_.emplace(key, index);
    MapBlock& block = blocks_[index];
    block.key = key;
    block.voxel = voxel;
    block.corner = (cell.mean / edge).array().floor().matrix() * edge;
    block.box = {block.corner - Eigen::Vector3f::Constant(voxel),
                 block.corner + Eigen::Vector3f::Constant(edge + voxel)};
    block.first.fill(-1);
  }
  MapBlock& block = blocks_[index];
  std::int16_t& head = block.first[block.voxel_of(cell.mean)];
  for (std::int16_t i = head; i >= 0; i = block.cells[static_cast<std::size_t>(i)].next)
    if (block.cells[static_cast<std::size_t>(i)].normal.dot(cell.normal) > kSameSide) return false;
  block.cells.push_back(cell);
  block.cells.back().size = voxel;
  block.cells.back().next = head;
  block.seen_s = std::max(block.seen_s, cell.seen_s);
  head = static_cast<std::int16_t>(block.cells.size() - 1);
  ++cell_count_;
  return true;
}

void MapBlocks::free_block(std::size_t index) {
  MapBlock& block = blocks_[index];
  cell_count_ -= block.cells.size();
  place_.erase(block.key);
  block = MapBlock{};
  free_.push_back(static_cast<std::uint32_t>(index));
}

void MapBlocks::sweep() {
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].voxel > 0 && blocks_[i].cells.empty()) free_block(i);
}

void MapBlocks::shrink_to(std::size_t most) {
  if (cell_count_ <= most) return;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].voxel > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return blocks_[a].seen_s < blocks_[b].seen_s;
  });
  for (const std::size_t i : order) {
    if (cell_count_ <= most) return;
    free_block(i);
  }
}

void MapBlocks::move(std::span<const Pose> motions) {
  std::vector<Eigen::Isometry3f> moves;
  moves.reserve(motions.size());
  for (const Pose& motion : motions) moves.push_back(motion.cast<float>());
  std::vector<std::vector<MapCell>> gone(blocks_.size());
  constexpr std::size_t kGrain = 16;  // blocks, some thousand cells
  parallel_chunks(blocks_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      MapBlock& block = blocks_[i];
      for (MapCell& cell : block.cells) {
        const Eigen::Isometry3f& by = moves[cell.keyframe];
        cell.mean = by * cell.mean;
        cell.normal = (by.linear() * cell.normal).normalized();
        cell.covariance = by.linear() * cell.covariance * by.linear().transpose();
        if (!block.box.contains(cell.mean)) gone[i].push_back(cell);
      }
      std::erase_if(block.cells,
                    [&](const MapCell& cell) { return !block.box.contains(cell.mean); });
      block.relink();
    }
  });
  for (const std::vector<MapCell>& cells : gone) cell_count_ -= cells.size();
  for (const std::vector<MapCell>& cells : gone)
    for (const MapCell& cell : cells) add(cell, std::ilogb(1.01F * cell.size / cell_m_));
  sweep();
}

void MapBlocks::rehang(KeyframeId from, KeyframeId to) {
  for (MapBlock& block : blocks_)
    for (MapCell& cell : block.cells)
      if (cell.keyframe == from) cell.keyframe = to;
}

void MapBlocks::clear() {
  blocks_.clear();
  free_.clear();
  place_.clear();
  cell_count_ = 0;
}

}  // namespace spool
