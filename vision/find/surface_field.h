// Which design sample is nearest, looked up in a grid: what makes thousands of poses cheap to try.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/core/cancel.h"
#include "vision/core/cloud_view.h"

namespace spool {

// A dense grid round the samples; each cell within `reach` of the surface holds the sample nearest
// to its middle. Immutable; const queries from many threads.
class SurfaceField {
 public:
  static constexpr std::uint16_t kFar = 0xFFFF;

  SurfaceField() = default;
  // `samples`: points with normals (m), under 65 535 of them. `cell_m`: edge of a cell; `reach_m`:
  // how far from the surface the field still knows it, which is less where it was cancelled.
  SurfaceField(const CloudView& samples, double cell_m, double reach_m, const Watch& watch = {});

  // The sample nearest to `point` (to within a cell), kFar beyond reach or outside the grid.
  [[nodiscard]] std::uint16_t nearest(const Eigen::Vector3f& point) const {
    const Eigen::Array3f cell = (point - corner_).array() * per_m_;
    if (!((cell >= 0.0F).all() && (cell < size_f_).all())) return kFar;  // NaN too
    const auto i = static_cast<std::size_t>(cell.x());
    const auto j = static_cast<std::size_t>(cell.y());
    const auto k = static_cast<std::size_t>(cell.z());
    return cells_[(k * size_y_ + j) * size_x_ + i];
  }
  [[nodiscard]] double reach_m() const { return reach_m_; }
  [[nodiscard]] double cell_m() const { return cell_m_; }

 private:
  double cell_m_ = 0, reach_m_ = 0;
  float per_m_ = 0;
  Eigen::Vector3f corner_ = Eigen::Vector3f::Zero();
  Eigen::Array3f size_f_ = Eigen::Array3f::Zero();
  std::size_t size_x_ = 0, size_y_ = 0, size_z_ = 0;
  std::vector<std::uint16_t> cells_;
};

}  // namespace spool
