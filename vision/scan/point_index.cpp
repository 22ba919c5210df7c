// Nearest neighbours: nanoflann behind a type of ours. Metres in, metres out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/point_index.h"

#include <cmath>

#include <Eigen/Geometry>
#include <nanoflann.hpp>

namespace spool {
namespace {

// The finite points and their places in the input, as nanoflann's queries read them.
struct FinitePoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> places;

  [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
};

struct Cancelled {};

// The same as they are read while the tree is built, which takes seconds over millions of points.
// nanoflann knows no cancelling: what it reads from is the only place where it can be stopped, and
// an exception, caught around the building, the only way out.
struct WatchedPoints : FinitePoints {
  const Watch* watch = nullptr;
  mutable std::uint32_t reads = 0;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    constexpr std::uint32_t kBetweenLooks = 1U << 16U;
    if (++reads % kBetweenLooks == 0 && watch->cancelled()) throw Cancelled{};
    return FinitePoints::kdtree_get_pt(i, axis);
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;  // nanoflann finds it
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, FinitePoints>,
                                                 WatchedPoints, 3, std::uint32_t>;

// The result sets: what nanoflann asks of one is worstDist() (squared, shrinking) and
// addPoint(). Distances stay squared until the search is over.
struct Nearest {
  using DistanceType = float;
  float bound;
  std::uint32_t best = 0;
  bool found = false;
  [[nodiscard]] std::size_t size() const { return found ? 1 : 0; }
  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] float worstDist() const { return bound; }
  bool addPoint(float squared, std::uint32_t i) {
    if (squared < bound) {
      bound = squared;
      best = i;
      found = true;
    }
    return true;
  }
};

// addPoint() says whether to go on: not once there is one.
struct Any {
  using DistanceType = float;
  float bound;
  bool found = false;
  [[nodiscard]] std::size_t size() const { return found ? 1 : 0; }
  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] float worstDist() const { return bound; }
  bool addPoint(float squared, std::uint32_t /*i*/) {
    found = squared < bound;
    return !found;
  }
};

struct NearestK {
  using DistanceType = float;
  std::vector<Neighbour>& out;  // sorted by (squared) distance
  std::size_t k;
  float bound;
  [[nodiscard]] std::size_t size() const { return out.size(); }
  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] float worstDist() const { return out.size() < k ? bound : out.back().distance; }
  bool addPoint(float squared, std::uint32_t i) {
    if (!(squared < worstDist())) return true;
    if (out.size() < k) out.push_back({});
    std::size_t at = out.size() - 1;
    for (; at > 0 && out[at - 1].distance > squared; --at) out[at] = out[at - 1];
    out[at] = {i, squared};
    return true;
  }
};

struct Within {
  using DistanceType = float;
  std::vector<Neighbour>& out;
  float bound;
  [[nodiscard]] std::size_t size() const { return out.size(); }
  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] float worstDist() const { return bound; }
  bool addPoint(float squared, std::uint32_t i) {
    if (squared < bound) out.push_back({i, squared});
    return true;
  }
};

}  // namespace

struct PointIndex::Impl {
  WatchedPoints cloud;
  std::unique_ptr<Tree> tree;  // empty without a point
  Eigen::AlignedBox3f box;

  // False where it was cancelled.
  [[nodiscard]] bool build(std::span<const Eigen::Vector3f> points, const Watch& watch);

  template <class Set>
  void search(Set& set, const Eigen::Vector3f& query) const {
    if (!tree || !query.allFinite() || !(box.squaredExteriorDistance(query) < set.worstDist()))
      return;
    tree->findNeighbors(set, query.data(), nanoflann::SearchParams());
  }

  void finish(std::vector<Neighbour>& out) const {
    for (Neighbour& neighbour : out)
      neighbour = {cloud.places[neighbour.index], std::sqrt(neighbour.distance)};
  }
};

PointIndex::PointIndex() : impl_(std::make_unique<Impl>()) {}
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;
PointIndex::~PointIndex() = default;

PointIndex::PointIndex(std::span<const Eigen::Vector3f> points, const Watch& watch) : PointIndex() {
  if (!impl_->build(points, watch)) impl_ = std::make_unique<Impl>();
}

bool PointIndex::Impl::build(std::span<const Eigen::Vector3f> points, const Watch& watch) {
  cloud.points.reserve(points.size());
  cloud.places.reserve(points.size());
  const bool copied = watched_loop(points.size(), watch, [&](std::size_t i) {
    if (!points[i].allFinite()) return;
    cloud.points.push_back(points[i]);
    cloud.places.push_back(static_cast<std::uint32_t>(i));
    box.extend(points[i]);
  });
  if (!copied) return false;
  if (cloud.points.empty()) return true;
  constexpr std::size_t kLeafPoints = 10;  // fastest queries of those tried
  cloud.watch = &watch;
  try {
    using nanoflann::KDTreeSingleIndexAdaptorFlags;
    tree = std::make_unique<Tree>(
        3, cloud,
        nanoflann::KDTreeSingleIndexAdaptorParams(
            kLeafPoints, KDTreeSingleIndexAdaptorFlags::SkipInitialBuildIndex));
    if (!watched_fill(tree->vAcc, cloud.points.size(), 0U, watch)) return false;
    tree->buildIndex();
  } catch (const Cancelled&) {
    return false;
  }
  cloud.watch = nullptr;

  // Points into the tree's own order: the ten of a leaf then lie side by side in memory.
  FinitePoints ordered;
  ordered.points.reserve(cloud.points.size());
  ordered.places.reserve(cloud.points.size());
  const bool reordered = watched_loop(tree->vAcc.size(), watch, [&](std::size_t i) {
    ordered.points.push_back(cloud.points[tree->vAcc[i]]);
    ordered.places.push_back(cloud.places[tree->vAcc[i]]);
    tree->vAcc[i] = static_cast<std::uint32_t>(i);
  });
  static_cast<FinitePoints&>(cloud) = std::move(ordered);  // the tree refers to `cloud` itself
  return reordered;
}

std::size_t PointIndex::size() const { return impl_->cloud.points.size(); }

std::optional<Neighbour> PointIndex::nearest(const Eigen::Vector3f& query,
                                             float max_distance) const {
  Nearest set{max_distance * max_distance};
  impl_->search(set, query);
  if (!set.found) return std::nullopt;
  return Neighbour{impl_->cloud.places[set.best], std::sqrt(set.bound)};
}

bool PointIndex::is_within(const Eigen::Vector3f& query, float max_distance) const {
  Any set{max_distance * max_distance};
  impl_->search(set, query);
  return set.found;
}

void PointIndex::nearest_k(const Eigen::Vector3f& query, std::size_t k, float max_distance,
                           std::vector<Neighbour>& out) const {
  out.clear();
  if (k == 0) return;
  NearestK set{out, k, max_distance * max_distance};
  impl_->search(set, query);
  impl_->finish(out);
}

void PointIndex::within(const Eigen::Vector3f& query, float radius,
                        std::vector<Neighbour>& out) const {
  out.clear();
  Within set{out, radius * radius};
  impl_->search(set, query);
  impl_->finish(out);
}

}  // namespace spool
