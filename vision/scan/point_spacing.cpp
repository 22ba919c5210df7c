// How far apart a scan's points are.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/point_spacing.h"

#include <vector>

#include "vision/core/median.h"

namespace spool {

float point_spacing(const PointIndex& index, std::span<const Eigen::Vector3f> points,
                    std::size_t step, float most) {
  constexpr std::size_t kWithItself = 5;
  std::vector<float> fourth;
  std::vector<Neighbour> near;
  for (std::size_t i = 0; i < points.size(); i += step) {
    index.nearest_k(points[i], kWithItself, most, near);
    fourth.push_back(near.size() == kWithItself ? near.back().distance : most);
  }
  return fourth.empty() ? most : median(fourth);
}

}  // namespace spool
