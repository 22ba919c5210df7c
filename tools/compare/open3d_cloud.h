// Our clouds as Open3D's.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <open3d/geometry/PointCloud.h>

#include "vision/core/point_cloud.h"

namespace spool::compare {

[[nodiscard]] inline open3d::geometry::PointCloud to_open3d(const PointCloud& from) {
  open3d::geometry::PointCloud to;
  for (const Eigen::Vector3f& p : from.points) to.points_.push_back(p.cast<double>());
  for (const Eigen::Vector3f& n : from.normals) to.normals_.push_back(n.cast<double>());
  return to;
}

}  // namespace spool::compare
