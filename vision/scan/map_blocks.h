// Where the map's cells lie: cubes of 8 by 8 by 8 voxels, found by their place.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vision/core/pose.h"

namespace spool {

// The camera's place that a piece of the map was made from: by its number. What the whole piece is
// off by is that place's, which later frames cannot see from the piece.
using KeyframeId = std::uint16_t;

// A piece of surface as large as its voxel: what all frames that saw it say of it.
struct MapCell {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();        // m, map frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();      // unit, towards where it was seen from
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();  // m^2, of one reading about the mean
  float size = 0;                                        // m, edge of its voxel
  float count = 0;                                       // readings, up to the map's limit
  float weight = 0;   // 1/m^2: one over the variance of the mean along the normal
  float bias = 0;     // recent residuals' mean, in standard deviations
  float against = 0;  // frames that looked through it, forgotten by halves where it is seen again
  KeyframeId keyframe = 0;  // that it moves with
  double seen_s = 0;        // when it was last seen
  std::int16_t next = -1;   // in the same voxel: the other side of a thin wall

  [[nodiscard]] float variance() const { return 1.0F / weight; }  // m^2, along the normal
};

// One cube of voxels of one size. Cells are in the order in which they came.
struct MapBlock {
  std::uint64_t key = 0;
  float voxel = 0;                                   // m; 0: the block is free
  Eigen::AlignedBox3f box;                           // m, with room for noise
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();  // m
  double seen_s = 0;                                 // when it was last in view
  std::vector<MapCell> cells = {};
  std::array<std::int16_t, 512> first = {};  // cell of each voxel, -1: none

  [[nodiscard]] std::size_t voxel_of(const Eigen::Vector3f& point) const;
  // Drops cells for which `dead(cell)`; gives how many.
  template <class Dead>
  std::size_t drop(const Dead& dead);

 private:
  friend class MapBlocks;
  void relink();
};

// Cells by place. Levels are voxel edges of `cell_m` times a power of two. One thread, but const
// from many.
class MapBlocks {
 public:
  explicit MapBlocks(float cell_m) : cell_m_(cell_m) {}

  [[nodiscard]] const std::vector<MapBlock>& blocks() const { return blocks_; }
  [[nodiscard]] std::vector<MapBlock>& blocks() { return blocks_; }
  [[nodiscard]] std::size_t cell_count() const { return cell_count_; }
  [[nodiscard]] float cell_m() const { return cell_m_; }

  // Adds the cell to the voxel of its level that holds its mean, unless one that looks the same way
  // (within 60 degrees) is there already. False: not added.
  bool add(const MapCell& cell, int level);
  template <class Dead>
  void drop(std::size_t block, const Dead& dead) {
    cell_count_ -= blocks_[block].drop(dead);
  }
  // Frees blocks in which nothing is left.
  void sweep();
  // Frees those that were out of view longest until at most `most` cells are left.
  void shrink_to(std::size_t most);
  // Moves each cell with its keyframe, by `motions[keyframe]` in the map frame. One that leaves its
  // block goes to another, unless one that looks the same way is in its voxel there already.
  void move(std::span<const Pose> motions);
  // Cells of keyframe `from` hang on `to` now, and stay where they are.
  void rehang(KeyframeId from, KeyframeId to);
  void clear();

 private:
  void free_block(std::size_t block);

  float cell_m_;
  std::size_t cell_count_ = 0;
  std::vector<MapBlock> blocks_;
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::uint64_t, std::uint32_t> place_;
};

template <class Dead>
std::size_t MapBlock::drop(const Dead& dead) {
  const std::size_t before = cells.size();
  std::erase_if(cells, dead);
  if (cells.size() != before) relink();
  return before - cells.size();
}

}  // namespace spool
