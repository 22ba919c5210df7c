// The plane that things stand on where the floor itself is not in the scan.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <vector>

#include <Eigen/Eigenvalues>

#include "vision/fit/plane.h"

namespace spool {
namespace {

constexpr std::size_t kMostPoints = 15000;  // looked at, evenly taken
constexpr int kDirections = 120;
constexpr double kCone = 0.45;         // rad, round `down`
constexpr double kMostBehind = 0.002;  // of the points: strays
constexpr std::size_t kMostTriples = 400;
// A hull has a facet in every direction, held by three corners or by an edge and a corner; a floor
// is met at more places, and not along one line.
constexpr double kPlace = 0.04;  // of the size
constexpr std::size_t kLeastPlaces = 8;
constexpr double kLeastSpread = 0.1;  // of the size; standard deviation across

std::vector<Eigen::Vector3f> some_of(std::span<const Eigen::Vector3f> points) {
  const std::size_t step = points.size() / kMostPoints + 1;
  std::vector<Eigen::Vector3f> some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

// The outermost points in directions round `down`, strays left aside, none within `apart_m` of
// another. Directions lie on a spiral, evenly over the cone's cap.
std::vector<Eigen::Vector3f> outermost(std::vector<Eigen::Vector3f> points,
                                       const Eigen::Vector3f& down, float apart_m) {
  const Eigen::Vector3f across = down.unitOrthogonal();
  const Eigen::Vector3f other = down.cross(across);
  const auto stray =
      static_cast<std::ptrdiff_t>(kMostBehind / 2 * static_cast<double>(points.size()));
  std::vector<Eigen::Vector3f> found;
  for (int i = 0; i < kDirections; ++i) {
    const double tilt = kCone * std::sqrt((i + 0.5) / kDirections);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));  // the golden angle
    const Eigen::Vector3f direction =
        static_cast<float>(std::cos(tilt)) * down +
        static_cast<float>(std::sin(tilt)) * (static_cast<float>(std::cos(turn)) * across +
                                              static_cast<float>(std::sin(turn)) * other);
    std::nth_element(points.begin(), points.begin() + stray, points.end(),
                     [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                       return a.dot(direction) > b.dot(direction);
                     });
    const Eigen::Vector3f p = points[static_cast<std::size_t>(stray)];
    if (std::none_of(found.begin(), found.end(),
                     [&](const Eigen::Vector3f& q) { return (p - q).norm() < apart_m; }))
      found.push_back(p);
  }
  return found;
}

struct Triple {
  double area = 0;
  DominantPlane plane;
};

// Planes through three of the points that look up, the widest first.
std::vector<Triple> planes_through(const std::vector<Eigen::Vector3f>& points,
                                   const Eigen::Vector3f& down) {
  std::vector<Triple> triples;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Eigen::Vector3f normal = (points[j] - points[i]).cross(points[k] - points[i]);
        const float area = normal.norm();
        const float facing = normal.dot(down) / area;
        if (!(std::abs(facing) > std::cos(static_cast<float>(kCone)))) continue;
        Triple triple;
        triple.area = double{area};
        triple.plane.normal = normal * (facing > 0 ? -1 : 1) / area;
        triple.plane.offset = triple.plane.normal.dot(points[i]);
        triples.push_back(triple);
      }
  const std::size_t most = std::min(triples.size(), kMostTriples);
  std::partial_sort(triples.begin(), triples.begin() + static_cast<std::ptrdiff_t>(most),
                    triples.end(),
                    [](const Triple& a, const Triple& b) { return a.area > b.area; });
  triples.resize(most);
  return triples;
}

std::vector<Eigen::Vector3f> points_on(const std::vector<Eigen::Vector3f>& points,
                                       const DominantPlane& plane, float band) {
  std::vector<Eigen::Vector3f> on;
  for (const Eigen::Vector3f& p : points)
    if (std::abs(plane.distance(p)) < band) on.push_back(p);
  return on;
}

// Least squares through what lies on it, its normal still up.
void fit(const std::vector<Eigen::Vector3f>& on, DominantPlane& plane) {
  const PlaneFit fitted = fit_plane(on);
  if (!fitted.is_determined) return;
  const Eigen::Vector3f normal = fitted.normal().cast<float>();
  plane.normal = normal.dot(plane.normal) < 0 ? Eigen::Vector3f(-normal) : normal;
  plane.offset = plane.normal.dot(fitted.centre().cast<float>());
}

bool has_nothing_behind(const std::vector<Eigen::Vector3f>& points, const DominantPlane& plane,
                        float band) {
  const auto behind = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
    return plane.distance(p) < -band;
  });
  return static_cast<double>(behind) <= kMostBehind * static_cast<double>(points.size());
}

// The middles of the cells that points lie in.
std::vector<Eigen::Vector3d> places(const std::vector<Eigen::Vector3f>& on, double place_m) {
  std::set<std::tuple<long, long, long>> cells;
  for (const Eigen::Vector3f& p : on) {
    const Eigen::Vector3d cell = p.cast<double>() / place_m;
    cells.emplace(std::lround(cell.x()), std::lround(cell.y()), std::lround(cell.z()));
  }
  std::vector<Eigen::Vector3d> middles;
  middles.reserve(cells.size());
  for (const auto& [x, y, z] : cells)
    middles.emplace_back(place_m * static_cast<double>(x), place_m * static_cast<double>(y),
                         place_m * static_cast<double>(z));
  return middles;
}

bool are_spread(const std::vector<Eigen::Vector3d>& places, double size_m) {
  if (places.size() < kLeastPlaces) return false;
  const auto count = static_cast<double>(places.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : places) mean += p / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : places)
    scatter.noalias() += (p - mean) * (p - mean).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[1])) > kLeastSpread * size_m;
}

}  // namespace

std::optional<DominantPlane> ground(std::span<const Eigen::Vector3f> points,
                                    std::span<const Eigen::Vector3f> witnesses,
                                    const Eigen::Vector3f& down, double size_m, double band_m) {
  const std::vector<Eigen::Vector3f> some = some_of(points), ends = some_of(witnesses);
  if (some.empty() || ends.empty()) return std::nullopt;
  const auto band = static_cast<float>(band_m);
  const double place_m = kPlace * size_m;
  const auto is_met = [&](const std::vector<Eigen::Vector3f>& on) {
    return are_spread(places(on, place_m), size_m);
  };
  for (Triple& triple : planes_through(outermost(some, down, static_cast<float>(place_m)), down)) {
    DominantPlane& plane = triple.plane;
    if (!has_nothing_behind(some, plane, band)) continue;
    std::vector<Eigen::Vector3f> on = points_on(ends, plane, band);
    if (!is_met(on)) continue;
    fit(on, plane);
    on = points_on(ends, plane, band);
    if (!is_met(on) || !has_nothing_behind(some, plane, band)) continue;
    plane.points = on.size();
    plane.patch = Occupancy(on, 2 * place_m);
    return plane;
  }
  return std::nullopt;
}

}  // namespace spool
