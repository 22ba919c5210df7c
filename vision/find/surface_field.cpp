// Which design sample is nearest, looked up in a grid.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/surface_field.h"

#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace spool {

SurfaceField::SurfaceField(const CloudView& samples, double cell_m, double reach_m,
                           const Watch& watch)
    : cell_m_(cell_m), reach_m_(reach_m), per_m_(static_cast<float>(1.0 / cell_m)) {
  assert(samples.size() < kFar && "samples are numbered in 16 bits");
  assert(cell_m > 0 && reach_m >= cell_m && "a field has cells and reaches past one");
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : samples.points) box.extend(point);
  if (box.isEmpty()) return;
  const auto margin = static_cast<float>(reach_m + cell_m);
  corner_ = box.min().array() - margin;
  const Eigen::Array3f cells = ((box.sizes().array() + 2 * margin) * per_m_).ceil().max(1.0F);
  size_f_ = cells;
  size_x_ = static_cast<std::size_t>(cells.x());
  size_y_ = static_cast<std::size_t>(cells.y());
  size_z_ = static_cast<std::size_t>(cells.z());
  cells_.assign(size_x_ * size_y_ * size_z_, kFar);

  const auto middle = [&](std::size_t i, std::size_t j, std::size_t k) -> Eigen::Vector3f {
    return corner_ +
           (Eigen::Vector3f(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k))
                .array() +
            0.5F)
                   .matrix() *
               static_cast<float>(cell_m);
  };
  // Grown from the samples outward, cell by cell, each keeping the nearest sample that reached it
  // (a vector distance transform; Danielsson 1980). Its error is far under a cell.
  struct Place {
    std::uint32_t i, j, k;
  };
  std::vector<float> squared(cells_.size(), static_cast<float>(reach_m * reach_m));
  std::vector<Place> front, next;
  const auto offer = [&](std::size_t i, std::size_t j, std::size_t k, std::uint16_t sample) {
    const std::size_t at = (k * size_y_ + j) * size_x_ + i;
    const float d = (middle(i, j, k) - samples.points[sample]).squaredNorm();
    if (d >= squared[at]) return;
    squared[at] = d;
    cells_[at] = sample;
    next.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                    static_cast<std::uint32_t>(k)});
  };
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Eigen::Array3f cell = (samples.points[s] - corner_).array() * per_m_;
    offer(static_cast<std::size_t>(cell.x()), static_cast<std::size_t>(cell.y()),
          static_cast<std::size_t>(cell.z()), static_cast<std::uint16_t>(s));
  }
  while (!next.empty() && !watch.cancelled()) {
    front.swap(next);
    next.clear();
    for (const Place& at : front) {
      const std::uint16_t sample = cells_[(at.k * size_y_ + at.j) * size_x_ + at.i];
      for (std::uint32_t k = at.k == 0 ? 0 : at.k - 1; k <= at.k + 1 && k < size_z_; ++k)
        for (std::uint32_t j = at.j == 0 ? 0 : at.j - 1; j <= at.j + 1 && j < size_y_; ++j)
          for (std::uint32_t i = at.i == 0 ? 0 : at.i - 1; i <= at.i + 1 && i < size_x_; ++i)
            offer(i, j, k, sample);
    }
  }
}

}  // namespace spool
