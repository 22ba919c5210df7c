// What a closed loop moves the design by: the piece of the scan map that its datum lies in.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/map_correction.h"

#include <cstddef>
#include <vector>

#include "vision/align/weak_directions.h"

namespace spool {

Eigen::AlignedBox3d datum_box(const DesignModel& design) {
  if (design.datums.empty() || design.is_cloud()) return design.bounds();
  const Part& part = design.parts[static_cast<std::size_t>(design.datums.front())];
  Eigen::AlignedBox3d box;
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    for (const auto corner : design.mesh.triangles[t])
      box.extend(design.mesh.vertices[static_cast<std::size_t>(corner)].cast<double>());
  return box.isEmpty() ? design.bounds() : box;
}

Pose motion_of_piece(const ScanMap& map, std::span<const Pose> motions,
                     const Pose& T_design_map_before, const Eigen::AlignedBox3d& box,
                     const Pose& otherwise) {
  std::vector<Eigen::Isometry3f> T_design_now;
  T_design_now.reserve(motions.size());
  for (const Pose& motion : motions)
    T_design_now.push_back((T_design_map_before * motion.inverse()).cast<float>());
  const Eigen::AlignedBox3f there = box.cast<float>();
  std::vector<std::size_t> counts(motions.size(), 0);
  std::size_t all = 0;
  for (const MapBlock& block : map.blocks())
    for (const MapCell& cell : block.cells)
      if (cell.keyframe < motions.size() &&
          there.contains(T_design_now[cell.keyframe] * cell.mean)) {
        ++counts[cell.keyframe];
        ++all;
      }
  if (all == 0) return otherwise;
  const Eigen::Vector3d middle = T_design_map_before.inverse() * box.center();
  Vector6d mean = Vector6d::Zero();
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const double share = static_cast<double>(counts[k]) / static_cast<double>(all);
    mean.head<3>() += share * (motions[k] * middle - middle);
    mean.tail<3>() += share * rotation_vector(motions[k].linear());
  }
  return moved_about(middle, mean, Pose::Identity());
}

}  // namespace spool
