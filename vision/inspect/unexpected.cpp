// Steel that the design does not have.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/unexpected.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "vision/inspect/deviation.h"
#include "vision/inspect/ground.h"
#include "vision/inspect/steel_bar.h"
#include "vision/scan/point_index.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr double kLeastReach = 0.08;  // m: less is a weld, a lug, dirt or the sensor's fringe
constexpr std::size_t kLeastPoints = 30;
constexpr double kJoined = 2.0;  // times the spacing of the scan's points
constexpr double kCell = 0.25;   // of what joins: closer points say no more of what hangs together
// What may lie between it and the floor: of the way that it comes nearer to it, and of its reach
// where it points straight at it (cosine of 15 degrees).
constexpr double kOfTheWay = 0.5, kStraightWay = 2.0;
constexpr float kStraight = 0.966F;
constexpr float kLonger = 1.3F;  // times as wide (standard deviations)
// Cosines to a plane's normal of a bar that neither stands on it nor runs along it: of 30 and 65
// degrees. Floor and table may meet it in the last part of its length alone.
constexpr float kUpright = 0.866F, kLevel = 0.42F;
constexpr float kEndOfBar = 0.5F;
// m; a longer thing is part of the spool only where it is a bar that comes out of the steel: what
// lies against it, or hangs together with what does, is seldom as short.
constexpr double kOddReach = 0.4;
constexpr double kFarthest = 2.0;  // m: no branch reaches further

std::vector<Eigen::Vector3f> thinned(std::span<const Eigen::Vector3f> points, double cell_m,
                                     const Watch& watch) {
  const PointCloud cells = thin_to_voxels(CloudView(points), cell_m, watch);
  std::vector<Eigen::Vector3f> some;
  some.reserve(cells.pixels.size());
  for (const std::uint32_t i : cells.pixels) some.push_back(points[i]);
  return some;
}

// Points joined to one another and to the spool.
// What meets at the spool alone, as a branch and a stand beside it do, is not one thing. It looks
// at one point of each cell, so that a scan of millions takes no longer than its surface is large.
class Growth {
 public:
  Growth(const UnexpectedScan& scan, const PointIndex& object, double step_m, const Watch& watch)
      : scan_(scan),
        step_m_(static_cast<float>(step_m)),
        points_(thinned(scan.left, kCell * step_m, watch)),
        most_(thinned(scan.object, kCell * step_m, watch).size()),
        left_(points_, watch),
        is_at_spool_(points_.size(), 0),
        is_met_(points_.size(), 0) {
    watched_loop(points_.size(), watch, [&](std::size_t i) {
      is_at_spool_[i] = object.is_within(points_[i], step_m_) ? 1 : 0;
    });
  }

  // One of each cell of what is left of the scan.
  [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
  [[nodiscard]] bool is_met(std::uint32_t i) const { return is_met_[i] != 0; }
  // The points() that are not at the spool, but joined to one that is, ascending.
  [[nodiscard]] std::vector<std::uint32_t> starts(const Watch& watch) const {
    std::vector<std::uint8_t> is_start(points_.size(), 0);
    std::vector<Neighbour> near;
    for (std::uint32_t i = 0; i < points_.size() && !watch.cancelled(); ++i) {
      if (is_at_spool_[i] == 0) continue;
      left_.within(points_[i], step_m_, near);
      for (const Neighbour& n : near) is_start[n.index] = is_at_spool_[n.index] == 0 ? 1 : 0;
    }
    std::vector<std::uint32_t> starts;
    for (std::uint32_t i = 0; i < is_start.size(); ++i)
      if (is_start[i] != 0) starts.push_back(i);
    return starts;
  }

  // Of what is left of the scan, all that lies where `some` of the points stand for it, ascending.
  [[nodiscard]] std::vector<std::uint32_t> all_of(const std::vector<std::uint32_t>& some) const {
    Eigen::AlignedBox3f box;
    for (const std::uint32_t i : some) box.extend(points_[i]);
    const auto cell = static_cast<float>(std::sqrt(3.0) * kCell) * step_m_;
    const Eigen::AlignedBox3f wider(box.min().array() - cell, box.max().array() + cell);
    std::vector<std::uint32_t> all;
    for (std::uint32_t k = 0; k < scan_.left.size(); ++k) {
      if (!wider.contains(scan_.left[k])) continue;
      const auto nearest = left_.nearest(scan_.left[k], cell);
      if (nearest && std::binary_search(some.begin(), some.end(), nearest->index)) all.push_back(k);
    }
    return all;
  }

  // All points() that are joined to the one at `first`, ascending; nothing where it is more than
  // the spool: a heap, a wall of clutter.
  std::optional<std::vector<std::uint32_t>> from(std::uint32_t first, const Watch& watch) {
    std::vector<std::uint32_t> points(1, first), at_spool;
    std::vector<Neighbour> near;
    is_met_[first] = 1;
    bool is_less = true;
    for (std::size_t at = 0; at < points.size() && !watch.cancelled(); ++at) {
      is_less = is_less && points.size() < most_;
      left_.within(points_[points[at]], step_m_, near);
      for (const Neighbour& n : near) {
        if (is_met_[n.index] != 0) continue;
        is_met_[n.index] = 1;
        (is_at_spool_[n.index] != 0 ? at_spool : points).push_back(n.index);
      }
    }
    points.insert(points.end(), at_spool.begin(), at_spool.end());
    if (!is_less || watch.cancelled()) return std::nullopt;
    std::sort(points.begin(), points.end());
    return points;
  }

 private:
  const UnexpectedScan& scan_;
  float step_m_;
  std::vector<Eigen::Vector3f> points_;
  std::size_t most_;  // as many would the spool have
  PointIndex left_;   // over points_
  std::vector<std::uint8_t> is_at_spool_;
  std::vector<std::uint8_t> is_met_;
};

// What stands is upright, or nearly so. A bar aslant that meets the floor, or nearly, was only
// welded on too long: it meets it with its end alone.
bool is_aslant(const SteelBar& bar, const DominantPlane& plane) {
  const float upright = std::abs(bar.direction.dot(plane.normal));
  return upright > kLevel && upright < kUpright;
}

bool touches(const DominantPlane& plane, std::span<const Eigen::Vector3f> points, float band,
             const std::optional<SteelBar>& bar) {
  const bool is_aslant_bar = bar && is_aslant(*bar, plane);
  return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
    return plane.holds(p, band) && !(is_aslant_bar && bar->along(p) > kEndOfBar * bar->length_m);
  });
}

// Which way the points run if they are longer than wide, unit, either sign; else zero.
Eigen::Vector3f longest_way(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : points) mean += p / static_cast<float>(points.size());
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const Eigen::Vector3f& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(scatter);  // ascending
  const bool is_longer = solver.eigenvalues()[2] > kLonger * kLonger * solver.eigenvalues()[1];
  return is_longer ? Eigen::Vector3f(solver.eigenvectors().col(2)) : Eigen::Vector3f::Zero();
}

// What reaches most of the way to floor, wall or table, or points straight at it from not far off,
// is a stand, the rest of which the scanner did not see. A branch there cannot be told from one.
// Of what is wide, as a post is, the way from its first point to its farthest goes across it.
bool is_a_stand(const Eigen::Vector3f& first, const Eigen::Vector3f& farthest, double reach_m,
                std::span<const Eigen::Vector3f> points, std::span<const DominantPlane> planes,
                const std::optional<SteelBar>& bar) {
  const Eigen::Vector3f along = (farthest - first).normalized(), way = longest_way(points);
  return std::any_of(planes.begin(), planes.end(), [&](const DominantPlane& plane) {
    const float distance = plane.distance(farthest);
    if (bar && is_aslant(*bar, plane)) return false;
    if (!plane.patch.is_near(farthest - distance * plane.normal)) return false;  // past its edge
    const float nearer = -along.dot(plane.normal) * std::copysign(1.0F, distance);
    const bool points_at_it =
        nearer > kStraight || (nearer > 0 && std::abs(way.dot(plane.normal)) > kStraight);
    const double left = double{std::abs(distance)};
    const double comes_nearer = double{std::abs(plane.distance(first))} - left;
    return left < (points_at_it ? kStraightWay * reach_m : kOfTheWay * comes_nearer);
  });
}

}  // namespace

std::vector<Unexpected> unexpected_steel(const DesignModel& design, const DesignSurface& surface,
                                         const UnexpectedScan& scan, const Watch& watch) {
  std::vector<Unexpected> found;
  if (scan.object.empty() || scan.left.empty()) return found;
  const std::vector<Eigen::Vector3f> object_points(scan.object.begin(), scan.object.end());
  const PointIndex object(object_points, watch);
  if (watch.cancelled()) return found;
  // As dense as the spool's own points, and no denser than noise lets be told.
  const double step = kJoined * vouching_radius(object, object_points, 5 * scan.noise_m);
  const auto band = static_cast<float>(step + 3 * scan.noise_m);
  Growth growth(scan, object, step, watch);
  // Where the floor is not in the scan: what ends where other things end.
  const auto stands_on_ground = [&](const std::vector<std::uint32_t>& points,
                                    const Eigen::Vector3f& first, const Eigen::Vector3f& last) {
    std::vector<Eigen::Vector3f> all(object_points), others;
    all.insert(all.end(), scan.left.begin(), scan.left.end());
    for (std::uint32_t k = 0; k < scan.left.size(); ++k)
      if (!std::binary_search(points.begin(), points.end(), k)) others.push_back(scan.left[k]);
    const auto floor =
        ground(all, others, (last - first).normalized(), design.bounds().diagonal().norm(), band);
    return floor && double{floor->distance(last)} < 2.0 * band;
  };
  const std::vector<Eigen::Vector3f>& left = growth.points();
  for (const std::uint32_t i : growth.starts(watch)) {
    if (watch.cancelled()) return {};
    if (growth.is_met(i)) continue;
    const std::optional<std::vector<std::uint32_t>> points = growth.from(i, watch);
    if (!points || points->size() < kLeastPoints) continue;
    std::vector<Eigen::Vector3f> places;
    for (const std::uint32_t at : *points) places.push_back(left[at]);
    const std::optional<SteelBar> bar = bar_out_of(surface, places);
    if (std::any_of(scan.planes.begin(), scan.planes.end(),
                    [&](const DominantPlane& plane) { return touches(plane, places, band, bar); }))
      continue;
    Unexpected it;
    std::map<std::int32_t, std::size_t> touched;
    Eigen::Vector3f farthest = left[i], nearest_joined = left[i];
    double least = kFarthest;
    for (const std::uint32_t at : *points) {
      const Eigen::Vector3f& p = left[at];
      if (const auto n = object.nearest(p, static_cast<float>(step)))
        ++touched[scan.object_part[n->index]];
      const auto nearest = surface.closest(p, static_cast<float>(kFarthest));
      const double reach = nearest ? std::abs(double{nearest->distance}) : kFarthest;
      if (reach > it.reach_m) {
        it.reach_m = reach;
        farthest = p;
      }
      if (reach < least) {
        least = reach;
        nearest_joined = p;
      }
    }
    const auto most =
        std::max_element(touched.begin(), touched.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == touched.end()) continue;  // what joins it was another's
    it.part = bar ? bar->part : most->first;
    if (it.reach_m < kLeastReach || it.reach_m >= (bar ? kFarthest : kOddReach) ||
        is_a_stand(nearest_joined, farthest, it.reach_m, places, scan.planes, bar) ||
        design.parts[static_cast<std::size_t>(it.part)].kind == PartKind::kSupport)
      continue;
    it.points = growth.all_of(*points);
    // Floors, walls and tables are at right angles: what is aslant to one stands on none.
    const bool stands_on_none =
        bar && std::any_of(scan.planes.begin(), scan.planes.end(),
                           [&](const DominantPlane& plane) { return is_aslant(*bar, plane); });
    if (!stands_on_none && stands_on_ground(it.points, nearest_joined, farthest)) continue;
    found.push_back(std::move(it));
  }
  return found;
}

}  // namespace spool
