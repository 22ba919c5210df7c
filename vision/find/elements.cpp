// Points with a direction, from the principal axes of their neighbourhoods.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/elements.h"

#include <cstdint>

#include <Eigen/Eigenvalues>

#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

// Variances: a patch is flat where the least is under a sixth of the middle one (a half pipe as
// wide as its neighbourhood is not), and has a width where that is over a tenth of the largest.
constexpr float kFlat = 1.0F / 6, kWide = 0.1F;
// Long: the middle variance is under a fifth of the largest.
constexpr float kLong = 0.2F;

bool direction_of(const std::vector<Eigen::Vector3f>& near, ElementKind kind, Element& element) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : near) mean += p;
  mean /= static_cast<float>(near.size());
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const Eigen::Vector3f& p : near) {
    const Eigen::Vector3f d = p - mean;
    scatter.noalias() += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(scatter);
  const Eigen::Vector3f& spread = axes.eigenvalues();
  if (!(spread[2] > 0)) return false;
  if (kind == ElementKind::kSurface) {
    if (spread[0] > kFlat * spread[1] || spread[1] < kWide * spread[2]) return false;
    element.direction = axes.eigenvectors().col(0);
    return true;
  }
  if (spread[1] > kLong * spread[2]) return false;
  element.point = mean;
  element.direction = axes.eigenvectors().col(2);
  return true;
}

}  // namespace

std::vector<Element> local_elements(std::span<const Eigen::Vector3f> points,
                                    const ElementOptions& options, const Watch& watch) {
  const PointIndex index(points);
  std::vector<Element> all(points.size());
  std::vector<std::uint8_t> good(points.size(), 0);
  const auto radius = static_cast<float>(options.radius_m);
  parallel_chunks(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    std::vector<Neighbour> neighbours;
    std::vector<Eigen::Vector3f> near;
    for (std::size_t i = begin; i < end; ++i) {
      index.within(points[i], radius, neighbours);
      if (neighbours.size() < options.min_neighbours) continue;
      near.clear();
      for (const Neighbour& n : neighbours) near.push_back(points[n.index] - points[i]);
      Element element{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
      if (!direction_of(near, options.kind, element)) continue;
      element.point += points[i];
      all[i] = element;
      good[i] = 1;
    }
  });
  std::vector<Element> elements;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (good[i] != 0) elements.push_back(all[i]);
  return elements;
}

}  // namespace spool
