// Normals of any cloud: the plane through each point's nearest neighbours.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <Eigen/Eigenvalues>

#include "vision/core/parallel.h"
#include "vision/scan/normals.h"

namespace spool {
namespace {

// The direction of least spread (unit), or zero where the neighbours span no plane: they coincide
// or lie on one line.
Eigen::Vector3d plane_normal(const std::vector<Eigen::Vector3f>& points,
                             const std::vector<Neighbour>& neighbours) {
  if (neighbours.size() < 3) return Eigen::Vector3d::Zero();
  const Eigen::Vector3f& near = points[neighbours.front().index];
  const auto count = static_cast<double>(neighbours.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Neighbour& neighbour : neighbours) {
    const Eigen::Vector3d offset = (points[neighbour.index] - near).cast<double>();
    sum += offset;
    squares += offset * offset.transpose();
  }
  const Eigen::Matrix3d scatter = squares - sum * sum.transpose() / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter);
  constexpr double kLine =
      1e-6;  // middle to largest spread (squared lengths): a line to a thousandth
  const Eigen::Vector3d& spread = solver.eigenvalues();
  if (!(spread[2] > 0) || spread[1] <= kLine * spread[2]) return Eigen::Vector3d::Zero();
  return solver.eigenvectors().col(0);
}

}  // namespace

void estimate_neighbour_normals(PointCloud& cloud, const PointIndex& index, int k,
                                const std::optional<Eigen::Vector3d>& viewpoint) {
  assert(k >= 3 && "three points make a plane");
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : cloud.points)
    if (point.allFinite()) box.extend(point);
  // No neighbour is further off than the cloud is wide. The query is one of the indexed points, so
  // that the search is short all the same.
  const float bound = box.isEmpty() ? 1.0F : box.diagonal().norm() * 1.001F + 1e-6F;
  std::vector<Eigen::Vector3f> normals(cloud.size(), Eigen::Vector3f::Zero());
  constexpr std::size_t kGrain = 4096;
  parallel_chunks(cloud.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> neighbours;
    for (std::size_t i = begin; i < end; ++i) {
      if (!cloud.points[i].allFinite()) continue;
      index.nearest_k(cloud.points[i], static_cast<std::size_t>(k), bound, neighbours);
      Eigen::Vector3d normal = plane_normal(cloud.points, neighbours);
      if (viewpoint && normal.dot(*viewpoint - cloud.points[i].cast<double>()) < 0)
        normal = -normal;
      normals[i] = normal.cast<float>();
    }
  });
  cloud.normals = std::move(normals);
}

}  // namespace spool
