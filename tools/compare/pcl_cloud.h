// Our clouds as PCL's.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "vision/core/point_cloud.h"

namespace spool::compare {

// `from` has normals.
[[nodiscard]] inline pcl::PointCloud<pcl::PointNormal>::Ptr to_pcl(const PointCloud& from) {
  auto to = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (std::size_t i = 0; i < from.size(); ++i) {
    pcl::PointNormal p;
    p.getVector3fMap() = from.points[i];
    p.getNormalVector3fMap() = from.normals[i];
    to->push_back(p);
  }
  return to;
}

}  // namespace spool::compare
