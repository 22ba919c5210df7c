// Density normalisation: one mean point a leaf of an octree (thesis 4.3.1).
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/octree_thinning.h"

#include <cassert>
#include <limits>

namespace spool {

PointCloud thin_by_octree(const CloudView& cloud, const OctreeOptions& options,
                          const Watch& watch) {
  const Octree tree(cloud.points, options, watch);
  PointCloud thin;
  for (const OctreeBin& bin : tree.bins()) {
    if (!bin.is_leaf() || bin.point_count == 0) continue;
    const auto places = std::span(tree.point_order()).subspan(bin.first_point, bin.point_count);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), normal_sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t place : places) {
      sum += cloud.points[place].cast<double>();
      if (cloud.has_normals()) normal_sum += cloud.normals[place].cast<double>();
    }
    const Eigen::Vector3f mean = (sum / bin.point_count).cast<float>();
    std::uint32_t nearest = places.front();
    for (const std::uint32_t place : places)
      if ((cloud.points[place] - mean).squaredNorm() < (cloud.points[nearest] - mean).squaredNorm())
        nearest = place;
    thin.points.push_back(mean);
    thin.pixels.push_back(nearest);
    if (!cloud.has_normals()) continue;
    const double length = normal_sum.norm();
    thin.normals.emplace_back(length > 1e-6 ? Eigen::Vector3f((normal_sum / length).cast<float>())
                                            : Eigen::Vector3f::Zero());
  }
  return thin;
}

OctreeOptions even_leaves(double leaf_m, OctreeSplit split) {
  assert(leaf_m > 0 && "a leaf has a size");
  return {.split = split,
          .bin_capacity = std::numeric_limits<std::size_t>::max(),
          .max_size_m = leaf_m,
          .size_of_points = true};
}

}  // namespace spool
