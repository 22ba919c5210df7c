// A cloud as parallel arrays: points, and where known their normals and the pixels they came from.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"

namespace spool {

// All arrays are empty or as long as `points`. Points are metres in the cloud's own frame, relative
// to `origin`: the file's coordinates are origin + point (far-off plant coordinates keep their
// precision).
struct PointCloud {
  std::vector<Eigen::Vector3f> points;   // m; NaN where an organised cloud has no measurement
  std::vector<Eigen::Vector3f> normals;  // unit, towards the sensor; zero where there is none
  std::vector<std::uint32_t> pixels;     // v * width + u, or the place in the file
  int width = 0;  // of an organised cloud (points.size() == width * height), else 0
  int height = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] bool empty() const { return points.empty(); }
  [[nodiscard]] bool has_normals() const {
    return !points.empty() && normals.size() == points.size();
  }
  [[nodiscard]] bool is_consistent() const {
    const auto fits = [this](std::size_t n) { return n == 0 || n == points.size(); };
    return fits(normals.size()) && fits(pixels.size()) &&
           (width == 0 ||
            points.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
};

// Points (and normals) in frame `to`; NaN stays NaN, the origin stays what it is.
[[nodiscard]] PointCloud moved(const PointCloud& cloud, const Pose& T_to_from);

}  // namespace spool
