// Distance to a bare design cloud: to the plane blended from the nearest design points, not to
// the points.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "vision/core/parallel.h"
#include "vision/design/surface_kinds.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kNeighbours = 8;        // blended: the ring round a point on an even sampling
constexpr int kNormalNeighbours = 16;         // for estimated normals
constexpr std::size_t kSpacingNeighbour = 6;  // its distance is what counts as the local spacing

// A query whose nearest design point lies further aside than this many spacings is past the edge of
// the sampled surface: the point, not its plane, is then what is closest.
constexpr float kReachSpacings = 1.5F;

class CloudSurface final : public SurfaceKind {
 public:
  CloudSurface(const CloudView& cloud, PointIndex index, std::vector<Eigen::Vector3f> estimated)
      : points_(cloud.points), index_(std::move(index)), estimated_(std::move(estimated)) {
    normals_ = estimated_.empty() ? cloud.normals : std::span<const Eigen::Vector3f>(estimated_);
    spacing_.resize(points_.size(), 0);
    parallel_chunks(points_.size(), 4096, [this](std::size_t begin, std::size_t end) {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i) {
        if (!points_[i].allFinite()) continue;
        index_.nearest_k(points_[i], kSpacingNeighbour + 1, std::numeric_limits<float>::max(),
                         found);
        if (!found.empty()) spacing_[i] = found.back().distance;
      }
    });
  }

  std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                      float max_distance) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    const std::optional<Neighbour> nearest = index_.nearest(query, max_distance);
    if (!nearest) return std::nullopt;
    SurfacePoint answer;
    answer.part = 0;
    answer.element = nearest->index;
    const Eigen::Vector3f& anchor = points_[nearest->index];
    const Eigen::Vector3f& normal = normals_[nearest->index];
    const Eigen::Vector3f offset = query - anchor;
    const float height = normal.dot(offset);
    const float aside = (offset - height * normal).norm();
    const float spacing = spacing_[nearest->index];
    if (normal.isZero() || aside > kReachSpacings * spacing) {
      answer.point = anchor;
      answer.normal = normal;
      answer.distance = std::copysign(nearest->distance, height);
      return answer;
    }
    blend(query, nearest->distance, spacing, normal, answer);
    return answer;
  }

  std::optional<RayHit> cast(const Eigen::Vector3f&, const Eigen::Vector3f&, float) const override {
    return std::nullopt;
  }

 private:
  // The mean of the neighbours' tangent planes, weighted by nearness (implicit moving least
  // squares, Kolluri, SODA 2005), normals turned as the nearest one's.
  void blend(const Eigen::Vector3f& query, float nearest_distance, float spacing,
             const Eigen::Vector3f& nearest_normal, SurfacePoint& answer) const {
    thread_local std::vector<Neighbour> found;  // its memory only, emptied by each search
    const float reach = std::hypot(nearest_distance, 2 * spacing);
    index_.nearest_k(query, kNeighbours, reach, found);
    const float squared_width = std::max(spacing * spacing, 1e-12F);
    float weight_sum = 0;
    float height_sum = 0;
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
    for (const Neighbour& each : found) {
      Eigen::Vector3f normal = normals_[each.index];
      if (normal.dot(nearest_normal) < 0) normal = -normal;
      // Measured from the nearest one's distance: far from the surface all would weigh nothing.
      const float excess = each.distance * each.distance - nearest_distance * nearest_distance;
      const float weight = std::exp(-std::max(excess, 0.0F) / squared_width);
      weight_sum += weight;
      height_sum += weight * normal.dot(query - points_[each.index]);
      normal_sum += weight * normal;
    }
    answer.normal = normal_sum.normalized();
    answer.distance = height_sum / weight_sum;
    answer.point = query - answer.distance * answer.normal;
  }

  std::span<const Eigen::Vector3f> points_;
  std::span<const Eigen::Vector3f> normals_;
  PointIndex index_;
  std::vector<Eigen::Vector3f> estimated_;
  std::vector<float> spacing_;  // m, of each point
};

}  // namespace

Result<std::unique_ptr<SurfaceKind>> make_cloud_surface(const CloudView& cloud) {
  PointIndex index(cloud.points);
  if (index.size() == 0) return Error{ErrorCode::kBadInput, "the design cloud has no finite point"};
  std::vector<Eigen::Vector3f> estimated;
  if (!cloud.has_normals()) {
    PointCloud copy;
    copy.points.assign(cloud.points.begin(), cloud.points.end());
    estimate_neighbour_normals(copy, index, kNormalNeighbours, std::nullopt);
    estimated = std::move(copy.normals);
  }
  return std::unique_ptr<SurfaceKind>(
      std::make_unique<CloudSurface>(cloud, std::move(index), std::move(estimated)));
}

}  // namespace spool
