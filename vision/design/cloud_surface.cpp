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
#include "vision/scan/spatial_order.h"

namespace spool {
namespace {

constexpr std::size_t kNeighbours = 8;        // blended: the ring round a point on an even sampling
constexpr int kNormalNeighbours = 16;         // for estimated normals
constexpr std::size_t kSpacingNeighbour = 6;  // its distance is what counts as the local spacing

// A query whose nearest design point lies further aside than this many spacings is past the edge of
// the sampled surface: the point, not its plane, is then what is closest.
constexpr float kReachSpacings = 1.5F;

// What an answer reads of a design point, side by side: half a cache line.
struct alignas(32) Sample {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, zero where unknown
  float spacing = 0;                                 // m
  std::uint32_t place = 0;                           // in the design cloud
};

class CloudSurface final : public SurfaceKind {
 public:
  // `places`: the finite points, in the order in which they are to lie in memory.
  CloudSurface(const CloudView& cloud, std::span<const Eigen::Vector3f> normals,
               std::span<const std::uint32_t> places) {
    samples_.resize(places.size());
    points_.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      points_[i] = cloud.points[places[i]];
      samples_[i] = {points_[i], normals[places[i]], 0, places[i]};
    }
    index_ = PointIndex(points_);
    parallel_chunks(samples_.size(), 4096, [this](std::size_t begin, std::size_t end) {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i) {
        index_.nearest_k(points_[i], kSpacingNeighbour + 1, std::numeric_limits<float>::max(),
                         found);
        if (!found.empty()) samples_[i].spacing = found.back().distance;
      }
    });
  }

  std::optional<SurfacePoint> closest(const Eigen::Vector3f& query,
                                      float max_distance) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    const std::optional<Neighbour> nearest = index_.nearest(query, max_distance);
    if (!nearest) return std::nullopt;
    return answer_near(query, *nearest, [&](float reach, std::vector<Neighbour>& found) {
      index_.nearest_k(query, kNeighbours, reach, found);
    });
  }

  std::optional<SurfacePoint> closest(const Eigen::Vector3f& query, float max_distance,
                                      float margin, SurfaceMemory& memory) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    thread_local std::vector<Neighbour> all;  // its memory only, as below
    remembered(memory, query, all);
    if (!answers(memory, query, max_distance, all)) {
      // What is remembered bounds the search: so many points are no further.
      const bool is_near = (!all.empty() && all.front().distance < max_distance) ||
                           index_.is_within(query, max_distance + margin);
      const float bound = all.size() == SurfaceMemory::kElements
                              ? 1.001F * all.back().distance + kMemorySlack
                              : std::numeric_limits<float>::max();
      memory.elements.fill(SurfaceMemory::kNone);
      memory.at = query;
      memory.reach_m = max_distance + margin;
      all.clear();
      if (is_near) {
        index_.nearest_k(query, SurfaceMemory::kElements, bound, all);
        // Of equally far ones the last may stand for others: short of it all are there.
        memory.reach_m = all.size() == SurfaceMemory::kElements ? all.back().distance
                                                                : std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < all.size(); ++i) memory.elements[i] = all[i].index;
      }
    }
    if (all.empty() || !(all.front().distance < max_distance)) return std::nullopt;
    return answer_near(query, all.front(), [&](float reach, std::vector<Neighbour>& found) {
      found.clear();
      for (const Neighbour& each : all)
        if (found.size() < kNeighbours && each.distance < reach) found.push_back(each);
    });
  }

  std::optional<SurfacePoint> closest_tangent(const Eigen::Vector3f& query,
                                              float max_distance) const override {
    if (!query.allFinite() || !(max_distance >= 0)) return std::nullopt;
    const std::optional<Neighbour> nearest = index_.nearest(query, max_distance);
    if (!nearest) return std::nullopt;
    return answer_near(query, *nearest,
                       [&](float, std::vector<Neighbour>& found) { found.assign(1, *nearest); });
  }

  bool is_within(const Eigen::Vector3f& query, float max_distance) const override {
    return query.allFinite() && max_distance >= 0 && index_.is_within(query, max_distance);
  }

  std::optional<RayHit> cast(const Eigen::Vector3f&, const Eigen::Vector3f&, float) const override {
    return std::nullopt;
  }

 private:
  // The remembered points by their distance from the query.
  void remembered(const SurfaceMemory& memory, const Eigen::Vector3f& query,
                  std::vector<Neighbour>& out) const {
    out.clear();
    if (memory.reach_m < 0) return;
    for (const std::uint32_t i : memory.elements) {
      if (i == SurfaceMemory::kNone) break;
      // Short: sorted as they come in.
      // Summed as the index does.
      const Eigen::Array3f d = (samples_[i].point - query).array().square();
      const Neighbour each{i, std::sqrt((d[0] + d[1]) + d[2])};
      std::size_t at = out.size();
      out.push_back(each);
      for (; at > 0 && each.distance < out[at - 1].distance; --at) out[at] = out[at - 1];
      out[at] = each;
    }
  }

  // Whether the remembered points are all that an answer to this query needs.
  [[nodiscard]] bool answers(const SurfaceMemory& memory, const Eigen::Vector3f& query,
                             float max_distance, const std::vector<Neighbour>& sorted) const {
    if (memory.reach_m < 0) return false;
    const float known = memory.reach_m - (query - memory.at).norm() - kMemorySlack;
    if (sorted.empty() || sorted.front().distance >= max_distance) return max_distance < known;
    if (sorted.size() < kNeighbours) return sorted.back().distance < known;
    return sorted[kNeighbours - 1].distance < known;
  }

  // The answer where `nearest` is the nearest point; `neighbours` gives those to blend within a
  // reach, nearest first.
  template <class Neighbours>
  [[nodiscard]] SurfacePoint answer_near(const Eigen::Vector3f& query, const Neighbour& nearest,
                                         const Neighbours& neighbours) const {
    SurfacePoint answer;
    answer.part = 0;
    const Sample& sample = samples_[nearest.index];
    answer.element = sample.place;
    const Eigen::Vector3f& anchor = sample.point;
    const Eigen::Vector3f& normal = sample.normal;
    const Eigen::Vector3f offset = query - anchor;
    const float height = normal.dot(offset);
    const float aside = (offset - height * normal).norm();
    const float spacing = sample.spacing;
    if (normal.isZero() || aside > kReachSpacings * spacing) {
      answer.point = anchor;
      answer.normal = normal;
      answer.distance = std::copysign(nearest.distance, height);
      return answer;
    }
    thread_local std::vector<Neighbour> found;  // its memory only, emptied by each search
    neighbours(std::hypot(nearest.distance, 2 * spacing), found);
    blend(query, nearest.distance, spacing, normal, found, answer);
    return answer;
  }

  // The mean of the neighbours' tangent planes, weighted by nearness (implicit moving least
  // squares, Kolluri, SODA 2005), normals turned as the nearest one's.
  void blend(const Eigen::Vector3f& query, float nearest_distance, float spacing,
             const Eigen::Vector3f& nearest_normal, std::span<const Neighbour> found,
             SurfacePoint& answer) const {
    const float squared_width = std::max(spacing * spacing, 1e-12F);
    float weight_sum = 0;
    float height_sum = 0;
    Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
    for (const Neighbour& each : found) {
      Eigen::Vector3f normal = samples_[each.index].normal;
      if (normal.dot(nearest_normal) < 0) normal = -normal;
      // Measured from the nearest one's distance: far from the surface all would weigh nothing.
      const float excess = each.distance * each.distance - nearest_distance * nearest_distance;
      const float weight = std::exp(-std::max(excess, 0.0F) / squared_width);
      weight_sum += weight;
      height_sum += weight * normal.dot(query - samples_[each.index].point);
      normal_sum += weight * normal;
    }
    answer.normal = normal_sum.normalized();
    answer.distance = height_sum / weight_sum;
    answer.point = query - answer.distance * answer.normal;
  }

  std::vector<Sample> samples_;
  std::vector<Eigen::Vector3f> points_;  // theirs: what the index borrows
  PointIndex index_;
};

}  // namespace

Result<std::unique_ptr<SurfaceKind>> make_cloud_surface(const CloudView& cloud) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (cloud.points[i].allFinite()) places.push_back(i);
  if (places.empty()) return Error{ErrorCode::kBadInput, "the design cloud has no finite point"};
  PointCloud estimated;
  if (!cloud.has_normals()) {
    estimated.points.assign(cloud.points.begin(), cloud.points.end());
    estimate_neighbour_normals(estimated, PointIndex(cloud.points), kNormalNeighbours,
                               std::nullopt);
  }
  // Neighbours side by side in memory, whatever order the design's samples come in.
  put_in_spatial_order(cloud.points, places);
  return std::unique_ptr<SurfaceKind>(std::make_unique<CloudSurface>(
      cloud,
      cloud.has_normals() ? cloud.normals : std::span<const Eigen::Vector3f>(estimated.normals),
      places));
}

}  // namespace spool
