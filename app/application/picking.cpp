// What a tap on a picture means.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/picking.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace spool {

namespace {
constexpr double kSlopMm = 1.5;
constexpr double kMmPerInch = 25.4;
constexpr double kOneSurfaceM = 0.03;  // m: further behind the foremost point is another surface
constexpr double kExactShare = 1.0 / 3.0;  // of the slop: right under the finger
constexpr double kReachM = 100.0;          // m

std::optional<Landmark> nearest_landmark(std::span<const Landmark> landmarks,
                                         const render::View& view, double x, double y,
                                         double slop_px) {
  const Landmark* nearest = nullptr;
  double nearest_px = slop_px;
  for (const Landmark& landmark : landmarks) {
    const render::Projected p = render::project(view, landmark.position);
    const double distance = std::hypot(p.x - x, p.y - y);
    if (p.depth_m > view.near_m && distance <= nearest_px) {
      nearest_px = distance;
      nearest = &landmark;
    }
  }
  return nearest != nullptr ? std::optional(*nearest) : std::nullopt;
}

}  // namespace

double tap_slop_px(double dots_per_inch) { return kSlopMm / kMmPerInch * dots_per_inch; }

std::optional<std::size_t> pick_point(std::span<const Eigen::Vector3f> points,
                                      const render::View& view, double x, double y,
                                      double slop_px) {
  struct Near {
    std::size_t index = 0;
    double distance_px = 0, depth_m = 0;
  };
  std::vector<Near> near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const render::Projected p = render::project(view, points[i].cast<double>());
    if (!(p.depth_m > view.near_m)) continue;  // behind the eye, or NaN
    const double distance = std::hypot(p.x - x, p.y - y);
    if (distance <= slop_px) near.push_back({i, distance, p.depth_m});
  }
  // What lies right under the finger goes before what lies only near it.
  for (const double reach : {kExactShare * slop_px, slop_px}) {
    double foremost = std::numeric_limits<double>::infinity();
    for (const Near& candidate : near) {
      if (candidate.distance_px <= reach) foremost = std::min(foremost, candidate.depth_m);
    }
    std::optional<std::size_t> best;
    double best_px = reach;
    for (const Near& candidate : near) {
      if (candidate.depth_m > foremost + kOneSurfaceM || candidate.distance_px > best_px) continue;
      best_px = candidate.distance_px;
      best = candidate.index;
    }
    if (best) return best;
  }
  return std::nullopt;
}

std::optional<Landmark> pick_design(const DesignModel& design, const DesignSurface& surface,
                                    std::span<const Landmark> landmarks, const render::View& view,
                                    double x, double y, double slop_px) {
  const auto part_name = [&](std::int32_t part) {
    return part >= 0 && static_cast<std::size_t>(part) < design.parts.size()
               ? design.parts[static_cast<std::size_t>(part)].name + ", where you tapped"
               : std::string("where you tapped");
  };
  if (design.is_cloud()) {
    const auto index = pick_point(design.cloud.points, view, x, y, slop_px);
    if (!index) return std::nullopt;
    return Landmark{design.cloud.points[*index].cast<double>(), 0, part_name(0)};
  }
  const Pose T_design_camera = view.T_camera_design.inverse();
  const Eigen::Vector3d direction =
      (T_design_camera.linear() * view.camera.back_project(x, y, 1.0)).normalized();
  const Eigen::Vector3d from = T_design_camera.translation();
  const auto hit =
      surface.cast(from.cast<float>(), direction.cast<float>(), static_cast<float>(kReachM));
  if (!hit) return nearest_landmark(landmarks, view, x, y, slop_px);
  return Landmark{from + static_cast<double>(hit->distance) * direction, hit->part,
                  part_name(hit->part)};
}

}  // namespace spool
