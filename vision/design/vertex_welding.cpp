// Vertices that lie on one another become one: a hashed grid whose cells are far larger than the
// tolerance.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/vertex_welding.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace spool {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Kept vertices by grid cell: hashed chains in two flat arrays.
class CellTable {
 public:
  explicit CellTable(std::size_t count)
      : heads_(std::bit_ceil(std::max<std::size_t>(count, 16)), kNone), next_(count, kNone) {}

  void insert(const Eigen::Array<std::int64_t, 3, 1>& cell, std::uint32_t vertex) {
    std::uint32_t& head = heads_[slot(cell)];
    next_[vertex] = head;
    head = vertex;
  }
  [[nodiscard]] std::uint32_t first(const Eigen::Array<std::int64_t, 3, 1>& cell) const {
    return heads_[slot(cell)];
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t vertex) const { return next_[vertex]; }

 private:
  [[nodiscard]] std::size_t slot(const Eigen::Array<std::int64_t, 3, 1>& cell) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      hash = (hash ^ static_cast<std::uint64_t>(cell[axis])) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash) & (heads_.size() - 1);
  }
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

std::vector<std::uint32_t> weld_vertices(std::span<const Eigen::Vector3f> vertices,
                                         float tolerance) {
  assert(tolerance > 0 && "a welding tolerance over zero");
  // With cells much wider than the tolerance nearly every vertex looks into one cell only.
  const double cell_m = 32.0 * static_cast<double>(tolerance);
  const auto cell_of = [cell_m](const Eigen::Array3d& p) {
    return Eigen::Array<std::int64_t, 3, 1>((p / cell_m).floor().cast<std::int64_t>());
  };
  CellTable table(vertices.size());
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    welded[v] = v;
    if (!vertices[v].allFinite()) continue;
    const Eigen::Array3d p = vertices[v].cast<double>().array();
    const auto low = cell_of(p - static_cast<double>(tolerance));
    const auto high = cell_of(p + static_cast<double>(tolerance));
    std::uint32_t found = kNone;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          for (std::uint32_t other = table.first({x, y, z}); other != kNone;
               other = table.after(other)) {
            if ((vertices[other] - vertices[v]).norm() <= tolerance) found = std::min(found, other);
          }
        }
      }
    }
    if (found != kNone) welded[v] = found;
    if (found == kNone) table.insert(cell_of(p), v);
  }
  return welded;
}

float welding_tolerance(std::span<const Eigen::Vector3f> vertices) {
  float largest = 0;
  for (const Eigen::Vector3f& vertex : vertices) {
    if (vertex.allFinite()) largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  }
  return std::max(1e-6F, 4 * largest * std::numeric_limits<float>::epsilon());
}

}  // namespace spool
