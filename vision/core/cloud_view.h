// A borrowed look at points and their normals: what algorithms take instead of a container.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <span>

#include <Eigen/Core>

#include "vision/core/point_cloud.h"

namespace spool {

// Points (m) with as many unit normals, or none. The cloud must outlive the view.
struct CloudView {
  std::span<const Eigen::Vector3f> points;
  std::span<const Eigen::Vector3f> normals;

  CloudView() = default;
  CloudView(std::span<const Eigen::Vector3f> points_in,
            std::span<const Eigen::Vector3f> normals_in = {})
      : points(points_in), normals(normals_in) {
    assert((normals.empty() || normals.size() == points.size()) &&
           "a normal for every point or none");
  }
  CloudView(const PointCloud& cloud)  // NOLINT(google-explicit-constructor): a view of it
      : CloudView(cloud.points, cloud.normals) {}

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] bool has_normals() const { return !normals.empty(); }
};

}  // namespace spool
