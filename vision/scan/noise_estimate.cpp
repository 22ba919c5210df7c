// The random error of a cloud's points, found in the cloud itself.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/noise_estimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "vision/core/median.h"
#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kNeighbours = 24;  // 18 degrees of freedom are left by a quadric's six
constexpr std::size_t kPlaces = 2000;
constexpr std::size_t kMinPlaces = 20;  // fewer say nothing of the cloud
constexpr double kFloor_m = 1e-4;

// How far the nearest neighbours may lie (m): twice the radius in which `kNeighbours` are expected
// were the points spread over the box's largest face; bounds the search without cutting real
// neighbourhoods.
float search_radius(const std::vector<Eigen::Vector3f>& points) {
  Eigen::AlignedBox3f box;
  for (const auto& point : points) box.extend(point);
  Eigen::Vector3f size = box.sizes();
  std::sort(size.data(), size.data() + 3);
  const float area = std::max(size[1] * size[2], 1e-8F);
  const float spacing = std::sqrt(area / static_cast<float>(points.size()));
  return std::min(1e3F, 4.0F * spacing * std::sqrt(static_cast<float>(kNeighbours)));
}

// The residual (m) of the neighbourhood about its own quadric; negative where there is none.
double residual_at(const std::vector<Eigen::Vector3f>& points,
                   const std::vector<Neighbour>& neighbours) {
  if (neighbours.size() < kNeighbours) return -1;
  Eigen::Matrix<double, 3, static_cast<int>(kNeighbours)> local;
  for (std::size_t i = 0; i < kNeighbours; ++i)
    local.col(static_cast<Eigen::Index>(i)) = points[neighbours[i].index].cast<double>();
  local.colwise() -= local.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(local * local.transpose());
  const double reach = std::sqrt(axes.eigenvalues()(2) / static_cast<double>(kNeighbours));
  if (!(reach > 0)) return -1;  // the same point over and over
  const auto in_plane = (axes.eigenvectors().rightCols<2>().transpose() * local / reach).eval();
  const Eigen::VectorXd height = (axes.eigenvectors().col(0).transpose() * local).transpose();
  Eigen::Matrix<double, static_cast<int>(kNeighbours), 6> terms;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(kNeighbours); ++i) {
    const double x = in_plane(0, i);
    const double y = in_plane(1, i);
    terms.row(i) << 1, x, y, x * x, x * y, y * y;
  }
  const Eigen::VectorXd fit = terms.colPivHouseholderQr().solve(height);
  return std::sqrt((height - terms * fit).squaredNorm() / static_cast<double>(kNeighbours - 6));
}

}  // namespace

double estimate_noise(const CloudView& cloud) {
  std::vector<Eigen::Vector3f> points;
  for (const auto& point : cloud.points)
    if (point.allFinite()) points.push_back(point);
  if (points.size() < 2 * kNeighbours) return kFloor_m;
  const PointIndex index(points);
  const float radius = search_radius(points);
  const std::size_t step = std::max<std::size_t>(1, points.size() / kPlaces);
  std::vector<double> residuals((points.size() + step - 1) / step, -1.0);
  parallel_chunks(residuals.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> neighbours;
    for (std::size_t i = begin; i < end; ++i) {
      index.nearest_k(points[i * step], kNeighbours, radius, neighbours);
      residuals[i] = residual_at(points, neighbours);
    }
  });
  std::erase_if(residuals, [](double residual) { return residual < 0; });
  if (residuals.size() < kMinPlaces) return kFloor_m;
  return std::max(kFloor_m, median(residuals));
}

}  // namespace spool
