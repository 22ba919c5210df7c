// A cloud in another frame.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/point_cloud.h"

#include <Eigen/Geometry>

namespace spool {

PointCloud moved(const PointCloud& cloud, const Pose& T_to_from) {
  PointCloud out = cloud;
  const Eigen::Isometry3f T = T_to_from.cast<float>();
  for (Eigen::Vector3f& point : out.points) point = T * point;
  for (Eigen::Vector3f& normal : out.normals) normal = T.linear() * normal;
  return out;
}

}  // namespace spool
