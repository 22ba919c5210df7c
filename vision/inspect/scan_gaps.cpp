// Whether the scan shows a part from end to end, or leaves out a length of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/scan_gaps.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kFewSamples = 8;  // a gap has more, or is all of the part

// How wide a part is (m) across its length: of a cylinder's wall, the diameter is 2 sqrt 2 standard
// deviations in a direction across.
float girth_m(const std::vector<Eigen::Vector3f>& surface) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : surface) mean += p.cast<double>();
  mean /= static_cast<double>(surface.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& p : surface) {
    const Eigen::Vector3d off = p.cast<double>() - mean;
    scatter.noalias() += off * off.transpose() / static_cast<double>(surface.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter, Eigen::EigenvaluesOnly);
  return static_cast<float>(std::sqrt(8 * std::max(0.0, axes.eigenvalues()[1])));
}

}  // namespace

std::vector<std::uint8_t> parts_with_gaps(
    const SurfaceSamples& samples, const std::vector<std::vector<Eigen::Vector3f>>& own_points,
    float near_m, const Watch& watch) {
  std::vector<std::vector<Eigen::Vector3f>> surface(own_points.size());
  for (std::size_t s = 0; s < samples.part.size(); ++s)
    surface[static_cast<std::size_t>(samples.part[s])].push_back(samples.cloud.points[s]);
  std::vector<std::uint8_t> has_gap(own_points.size(), 0);
  parallel_chunks(own_points.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && !watch.cancelled(); ++p) {
      if (surface[p].empty()) continue;
      const PointIndex shown(own_points[p], watch);
      const float across = std::max(girth_m(surface[p]), near_m);
      const auto bare = static_cast<std::size_t>(
          std::count_if(surface[p].begin(), surface[p].end(),
                        [&](const Eigen::Vector3f& q) { return !shown.is_within(q, across); }));
      has_gap[p] = bare >= std::min(kFewSamples, surface[p].size()) ? 1 : 0;
    }
  });
  return has_gap;
}

}  // namespace spool
