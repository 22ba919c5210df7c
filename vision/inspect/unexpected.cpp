// Steel that the design does not have.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/unexpected.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "vision/inspect/deviation.h"
#include "vision/inspect/ground.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr double kLeastReach = 0.08;  // m: less is a weld, a lug, dirt or the sensor's fringe
constexpr std::size_t kLeastPoints = 30;
constexpr double kJoined = 2.0;  // times the spacing of the scan's points
// Of its reach: what may lie between it and the floor, and where it points straight at it (cosine
// of 15 degrees).
constexpr double kOfTheWay = 0.5, kStraightWay = 2.0;
constexpr float kStraight = 0.966F;
constexpr double kFarthest = 2.0;  // m: no branch reaches further

// Points joined to one another and to the spool, followed until they turn out to be held elsewhere.
class Growth {
 public:
  Growth(const UnexpectedScan& scan, double step_m, const Watch& watch)
      : scan_(scan),
        step_m_(static_cast<float>(step_m)),
        left_(scan.left, watch),
        is_met_(scan.left.size(), 0) {}

  [[nodiscard]] bool is_met(std::uint32_t i) const { return is_met_[i] != 0; }

  // All that is joined to point `first`; nothing where something else holds it, or where it is more
  // than the spool: a heap, a wall of clutter.
  std::optional<std::vector<std::uint32_t>> from(std::uint32_t first, const Watch& watch) {
    std::vector<std::uint32_t> points(1, first);
    std::vector<Neighbour> near;
    is_met_[first] = 1;
    bool is_free = true;
    for (std::size_t at = 0; at < points.size() && !watch.cancelled(); ++at) {
      const Eigen::Vector3f& p = scan_.left[points[at]];
      is_free = is_free && points.size() < scan_.object.size() && !touches_plane(p);
      left_.within(p, step_m_, near);
      for (const Neighbour& n : near) {
        if (is_met_[n.index] != 0) continue;
        is_met_[n.index] = 1;
        points.push_back(n.index);
      }
    }
    if (!is_free || watch.cancelled()) return std::nullopt;
    std::sort(points.begin(), points.end());
    return points;
  }

 private:
  [[nodiscard]] bool touches_plane(const Eigen::Vector3f& p) const {
    const float band = step_m_ + static_cast<float>(3 * scan_.noise_m);
    return std::any_of(scan_.planes.begin(), scan_.planes.end(),
                       [&](const DominantPlane& plane) { return plane.holds(p, band); });
  }

  const UnexpectedScan& scan_;
  float step_m_;
  PointIndex left_;
  std::vector<std::uint8_t> is_met_;
};

// What reaches most of the way to floor, wall or table, or points straight at it from not far off,
// is a stand, the rest of which the scanner did not see. A branch there cannot be told from one.
bool is_a_stand(const Eigen::Vector3f& first, const Eigen::Vector3f& farthest, double reach_m,
                std::span<const DominantPlane> planes) {
  const Eigen::Vector3f along = (farthest - first).normalized();
  return std::any_of(planes.begin(), planes.end(), [&](const DominantPlane& plane) {
    const float distance = plane.distance(farthest);
    if (!plane.patch.is_near(farthest - distance * plane.normal)) return false;  // past its edge
    const bool points_at_it = -along.dot(plane.normal) * std::copysign(1.0F, distance) > kStraight;
    return double{std::abs(distance)} < (points_at_it ? kStraightWay : kOfTheWay) * reach_m;
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
  Growth growth(scan, step, watch);
  // Where the floor is not in the scan: what ends where other things end.
  const auto stands_on_ground = [&](const std::vector<std::uint32_t>& points,
                                    const Eigen::Vector3f& first, const Eigen::Vector3f& last) {
    std::vector<Eigen::Vector3f> all(object_points), others;
    all.insert(all.end(), scan.left.begin(), scan.left.end());
    for (std::uint32_t k = 0; k < scan.left.size(); ++k)
      if (!std::binary_search(points.begin(), points.end(), k)) others.push_back(scan.left[k]);
    const double band = step + 3 * scan.noise_m;
    const auto floor =
        ground(all, others, (last - first).normalized(), design.bounds().diagonal().norm(), band);
    return floor && double{floor->distance(last)} < 2 * band;
  };
  for (std::uint32_t i = 0; i < scan.left.size() && !watch.cancelled(); ++i) {
    if (growth.is_met(i) || !object.nearest(scan.left[i], static_cast<float>(step))) continue;
    std::optional<std::vector<std::uint32_t>> points = growth.from(i, watch);
    if (!points || points->size() < kLeastPoints) continue;
    Unexpected it;
    std::map<std::int32_t, std::size_t> touched;
    Eigen::Vector3f farthest = scan.left[i], nearest_joined = scan.left[i];
    double least = kFarthest;
    for (const std::uint32_t at : *points) {
      const Eigen::Vector3f& p = scan.left[at];
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
    it.part = most->first;
    if (it.reach_m < kLeastReach || it.reach_m >= kFarthest ||
        is_a_stand(nearest_joined, farthest, it.reach_m, scan.planes) ||
        design.parts[static_cast<std::size_t>(it.part)].kind == PartKind::kSupport ||
        stands_on_ground(*points, nearest_joined, farthest))
      continue;
    it.points = std::move(*points);
    found.push_back(std::move(it));
  }
  return found;
}

}  // namespace spool
