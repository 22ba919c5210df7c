// What an oriented pair of points looks like from anywhere: three angles, and the cell they fall
// in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace spool {

// The angles (rad, 0 to pi) of eq. 4.1 between n1 and d, n2 and d, n1 and n2, where d leads from p1
// to p2 (thesis 4.3.2; Papazov & Burschka 2010). Points in m, unit normals, one frame.
[[nodiscard]] Eigen::Array3f pair_feature(const Eigen::Vector3f& p1, const Eigen::Vector3f& n1,
                                          const Eigen::Vector3f& p2, const Eigen::Vector3f& n2);

// False where both normals lie along the line of the pair to within `limit_rad`: any turn about it
// then fits as well, and no pose follows.
[[nodiscard]] bool fixes_a_pose(const Eigen::Array3f& feature, double limit_rad);

// The cube of cells that the three angles are hashed into.
class FeatureCells {
 public:
  // Cells of edge `cell_rad` (rad, over 0 and at most pi); the last of an axis may reach past pi.
  explicit FeatureCells(double cell_rad);
  [[nodiscard]] std::size_t count() const { return per_axis_ * per_axis_ * per_axis_; }
  // 0 to count() - 1, for angles in 0 to pi.
  [[nodiscard]] std::size_t cell_of(const Eigen::Array3f& feature) const;

 private:
  double cell_rad_;
  std::size_t per_axis_;
};

}  // namespace spool
