// Fewer points of the same surface: a voxel grid keeps the mean of each cell.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/thinning.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace spool {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

// Cells met so far, numbered in the order of their first point. A cell is its three floored
// coordinates, kept as doubles: they are exact for every finite float and every cell size.
class CellTable {
 public:
  explicit CellTable(double cell_m, std::size_t expected) : per_m_(1.0 / cell_m) {
    rehash(std::bit_ceil(std::max<std::size_t>(1024, expected * 2)));
  }

  [[nodiscard]] std::size_t size() const { return cells_.size(); }

  std::uint32_t find_or_add(const Eigen::Vector3f& point) {
    // + 0.0 makes the two zeros one.
    const Eigen::Array3d cell = (point.cast<double>().array() * per_m_).floor() + 0.0;
    std::size_t slot = hash(cell) & mask_;
    for (; slots_[slot] != kFree; slot = (slot + 1) & mask_)
      if ((cells_[slots_[slot]] == cell).all()) return slots_[slot];
    const auto number = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(cell);
    slots_[slot] = number;
    if (cells_.size() * 2 > slots_.size()) rehash(slots_.size() * 2);
    return number;
  }

 private:
  static std::size_t hash(const Eigen::Array3d& cell) {
    std::uint64_t h = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      h ^= std::bit_cast<std::uint64_t>(cell[axis]);
      h *= 0x9E3779B97F4A7C15U;  // 2^64 over the golden ratio: spreads neighbouring cells
      h ^= h >> 29U;
    }
    return h;
  }

  void rehash(std::size_t slots) {
    slots_.assign(slots, kFree);
    mask_ = slots - 1;
    for (std::uint32_t number = 0; number < cells_.size(); ++number) {
      std::size_t slot = hash(cells_[number]) & mask_;
      while (slots_[slot] != kFree) slot = (slot + 1) & mask_;
      slots_[slot] = number;
    }
  }

  double per_m_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> slots_;
  std::vector<Eigen::Array3d> cells_;
};

// Occupied cells, counted no further than `limit` + 1.
std::size_t count_cells(const CloudView& cloud, double cell_m, std::size_t limit) {
  CellTable table(cell_m, limit);
  for (const Eigen::Vector3f& point : cloud.points) {
    if (!point.allFinite()) continue;
    table.find_or_add(point);
    if (table.size() > limit) break;
  }
  return table.size();
}

struct Cell {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  std::uint32_t count = 0;
  float nearest_squared = std::numeric_limits<float>::infinity();  // m^2, to the mean
};

}  // namespace

PointCloud thin_to_voxels(const CloudView& cloud, double cell_m, const Watch& watch) {
  assert(cell_m > 0 && "a cell has a size");
  CellTable table(cell_m, cloud.size() / 8);
  std::vector<Cell> cells;
  std::vector<std::uint32_t> cell_of;
  if (!watched_fill(cell_of, cloud.size(), kFree, watch)) return {};
  const bool is_sorted = watched_loop(cloud.size(), watch, [&](std::size_t i) {
    const Eigen::Vector3f& point = cloud.points[i];
    if (!point.allFinite()) return;
    const std::uint32_t number = table.find_or_add(point);
    if (number == cells.size()) cells.emplace_back();
    Cell& cell = cells[number];
    cell.sum += point.cast<double>();
    if (cloud.has_normals()) cell.normal_sum += cloud.normals[i].cast<double>();
    ++cell.count;
    cell_of[i] = number;
  });
  if (!is_sorted) return {};

  PointCloud thin;
  thin.points.reserve(cells.size());
  for (const Cell& cell : cells) {
    thin.points.emplace_back((cell.sum / cell.count).cast<float>());
    if (!cloud.has_normals()) continue;
    const double length = cell.normal_sum.norm();
    thin.normals.emplace_back(length > 1e-6
                                  ? Eigen::Vector3f((cell.normal_sum / length).cast<float>())
                                  : Eigen::Vector3f::Zero());
  }
  thin.pixels.resize(cells.size());
  const bool has_nearest = watched_loop(cloud.size(), watch, [&](std::size_t i) {
    if (cell_of[i] == kFree) return;
    Cell& cell = cells[cell_of[i]];
    const float squared = (cloud.points[i] - thin.points[cell_of[i]]).squaredNorm();
    if (squared < cell.nearest_squared) {
      cell.nearest_squared = squared;
      thin.pixels[cell_of[i]] = static_cast<std::uint32_t>(i);
    }
  });
  return has_nearest ? thin : PointCloud{};
}

double voxel_size_for(const CloudView& cloud, std::size_t target) {
  assert(target > 0 && "at least one point has to stay");
  Eigen::AlignedBox3d box;
  std::size_t finite = 0;
  for (const Eigen::Vector3f& point : cloud.points) {
    if (!point.allFinite()) continue;
    box.extend(point.cast<double>());
    ++finite;
  }
  if (finite <= target) return 0;

  const std::size_t most = target + target / 20;   // 5 % over
  const std::size_t least = target - target / 20;  // near enough: stop
  const std::size_t limit = most * 4;              // counted no further
  const Eigen::Vector3d sides = box.sizes();
  const double diagonal = std::max(sides.norm(), 1e-6);
  // A scan is a surface: its cells go with 1 / edge^2. First guess: the box's largest side face.
  const double area =
      std::max({sides.x() * sides.y(), sides.y() * sides.z(), sides.z() * sides.x()});
  double edge =
      std::clamp(std::sqrt(area / static_cast<double>(target)), diagonal * 1e-6, diagonal);
  double too_fine = 0;                  // an edge that leaves too many
  double coarse_enough = diagonal * 2;  // one that leaves few enough (at most eight cells)
  constexpr int kTries = 24;
  for (int i = 0; i < kTries; ++i) {
    const std::size_t count = count_cells(cloud, edge, limit);
    if (count > most) {
      too_fine = edge;
    } else {
      coarse_enough = edge;
      if (count >= least) break;
    }
    edge *= std::sqrt(static_cast<double>(count) / static_cast<double>(target));
    if (edge <= too_fine || edge >= coarse_enough)
      edge = too_fine > 0 ? std::sqrt(too_fine * coarse_enough) : coarse_enough / 2;
    if (too_fine > 0 && coarse_enough < too_fine * 1.001) break;
  }
  return coarse_enough;
}

}  // namespace spool
