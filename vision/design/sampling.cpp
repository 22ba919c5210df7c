// Poisson-disk samples: an even pool of candidates, thrown as darts, at a radius sought for the
// count.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include <Eigen/Geometry>

#include "vision/design/dart_thrower.h"

namespace spool {
namespace {

// A place on the surface that may become a sample.
struct Candidate {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  std::uint32_t element = 0;  // triangle, or point of a cloud design
};

using Corners = std::array<Eigen::Vector3d, 3>;

// Disks thrown at random until none fits cover 0.547 of a plane (random sequential adsorption),
// each disk as wide as the radius between samples.
constexpr double kSaturation = 0.547;
constexpr std::size_t kPoolPerSample = 10;

// In [0, 1): the same on every standard library, which std::uniform_real_distribution need not be.
double unit_random(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

std::size_t below(std::mt19937& random, std::size_t limit) {
  return static_cast<std::size_t>(unit_random(random) * static_cast<double>(limit));
}

void shuffle(std::vector<Candidate>& candidates, std::mt19937& random) {
  for (std::size_t i = candidates.size(); i > 1; --i) {
    std::swap(candidates[i - 1], candidates[below(random, i)]);
  }
}

Corners corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = mesh.vertices[mesh.triangles[triangle][k]].cast<double>();
  }
  return corners;
}

double area(const Corners& p) { return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm(); }

Eigen::Vector3d random_point(const Corners& p, std::mt19937& random) {
  const double root = std::sqrt(unit_random(random));
  const double along = unit_random(random);
  return (1 - root) * p[0] + root * (1 - along) * p[1] + root * along * p[2];
}

// Candidates in proportion to area: one at random in each of `count` equal shares of the total.
std::vector<Candidate> area_pool(const TriangleMesh& mesh, const std::vector<double>& area_up_to,
                                 std::size_t count, std::mt19937& random) {
  std::vector<Candidate> pool;
  pool.reserve(count);
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = area_up_to.back() * (static_cast<double>(i) + unit_random(random)) /
                      static_cast<double>(count);
    while (triangle + 1 < area_up_to.size() && area_up_to[triangle] <= at) ++triangle;
    pool.push_back({random_point(corners_of(mesh, triangle), random).cast<float>(),
                    static_cast<std::uint32_t>(triangle)});
  }
  return pool;
}

// One candidate in every piece when triangles are halved at their longest edge until that is at
// most `length`: wherever one stands on the surface, a candidate lies within `length`.
std::vector<Candidate> covering_pool(const TriangleMesh& mesh, double length,
                                     std::mt19937& random) {
  std::vector<Candidate> pool;
  std::vector<Corners> pieces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    pieces.assign(1, corners_of(mesh, t));
    while (!pieces.empty()) {
      const Corners p = pieces.back();
      pieces.pop_back();
      std::size_t longest = 0;
      for (std::size_t k = 1; k < 3; ++k) {
        if ((p[(k + 1) % 3] - p[k]).norm() > (p[(longest + 1) % 3] - p[longest]).norm())
          longest = k;
      }
      const Eigen::Vector3d& a = p[longest];
      const Eigen::Vector3d& b = p[(longest + 1) % 3];
      const Eigen::Vector3d& c = p[(longest + 2) % 3];
      if ((b - a).norm() <= length) {
        pool.push_back({random_point(p, random).cast<float>(), static_cast<std::uint32_t>(t)});
        continue;
      }
      const Eigen::Vector3d middle = 0.5 * (a + b);
      pieces.push_back({a, middle, c});
      pieces.push_back({middle, b, c});
    }
  }
  return pool;
}

// A throw at one radius: which of the pool were taken.
std::vector<Candidate> thrown(const std::vector<Candidate>& pool, DartThrower& darts,
                              const Watch& watch) {
  std::vector<Candidate> taken;
  std::size_t done = 0;
  for (const Candidate& each : pool) {
    if (++done % 4096 == 0 && watch.cancelled()) break;
    if (darts.throw_dart(each.point)) taken.push_back(each);
  }
  return taken;
}

struct Throw {
  std::vector<Candidate> taken;
  double radius = 0;  // m
};

// The throw whose count is nearest to `count` of those tried; stops within 3 %. Counts fall as the
// square of the radius on a plane, faster where two sheets lie closer than it: hence steps, not a
// formula.
Throw seek(double radius, std::size_t count,
           const std::function<std::vector<Candidate>(double)>& at, const Watch& watch) {
  Throw best;
  double low = 0;   // a radius that gave too many
  double high = 0;  // one that gave too few
  const auto miss = [count](const Throw& t) {
    return std::abs(static_cast<double>(t.taken.size()) / static_cast<double>(count) - 1);
  };
  for (int round = 0; round < 24 && !watch.cancelled(); ++round) {
    Throw now{at(radius), radius};
    const double ratio = static_cast<double>(now.taken.size()) / static_cast<double>(count);
    (ratio > 1 ? low : high) = radius;
    if (best.radius == 0 || miss(now) < miss(best)) best = std::move(now);
    if (miss(best) < 0.03) break;
    radius *= std::clamp(std::sqrt(ratio), 0.25, 4.0);
    const bool between = low > 0 && high > 0;
    if (between && !(radius > low && radius < high)) radius = std::sqrt(low * high);
  }
  return best;
}

SurfaceSamples sample_mesh(const DesignModel& design, std::size_t count, std::mt19937& random,
                           const Watch& watch) {
  const TriangleMesh& mesh = design.mesh;
  std::vector<double> area_up_to(mesh.triangles.size());
  double total = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area_up_to[t] = total += area(corners_of(mesh, t));
  }
  SurfaceSamples samples;
  if (!(total > 0)) return samples;
  std::vector<Candidate> pool = area_pool(mesh, area_up_to, kPoolPerSample * count, random);
  shuffle(pool, random);
  const double start =
      std::sqrt(4 * kSaturation * total / (std::numbers::pi * static_cast<double>(count)));
  const std::uint32_t gap_seed = static_cast<std::uint32_t>(random());
  const auto at = [&](double radius) {
    DartThrower darts(radius, 2 * count);
    std::vector<Candidate> taken = thrown(pool, darts, watch);
    // Then the gaps that chance left. A refused candidate has a sample within the radius, and every
    // place of the surface has a candidate within the radius: together, within two.
    std::mt19937 gap_random(gap_seed);
    std::vector<Candidate> gaps = covering_pool(mesh, radius, gap_random);
    shuffle(gaps, gap_random);
    const std::vector<Candidate> filling = thrown(gaps, darts, watch);
    taken.insert(taken.end(), filling.begin(), filling.end());
    return taken;
  };
  const Throw best = seek(start, count, at, watch);
  samples.radius_m = best.radius;
  for (const Candidate& each : best.taken) {
    const Corners p = corners_of(mesh, each.element);
    samples.cloud.points.push_back(each.point);
    samples.cloud.normals.push_back((p[1] - p[0]).cross(p[2] - p[0]).normalized().cast<float>());
    samples.part.push_back(design.triangle_part[each.element]);
  }
  return samples;
}

SurfaceSamples sample_points(const DesignModel& design, std::size_t count, std::mt19937& random,
                             const Watch& watch) {
  const PointCloud& cloud = design.cloud;
  std::vector<Candidate> pool;
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.points[i].allFinite()) pool.push_back({cloud.points[i], i});
  }
  SurfaceSamples samples;
  if (pool.empty()) return samples;
  shuffle(pool, random);
  Throw best{pool, 0};  // all of them where there are no more than asked for
  if (pool.size() > count) {
    const double size = std::max(design.bounds().sizes().norm(), 1e-6);
    const auto at = [&](double radius) {
      DartThrower darts(radius, 2 * count);
      return thrown(pool, darts, watch);
    };
    best = seek(size / std::sqrt(static_cast<double>(count)), count, at, watch);
  }
  samples.radius_m = best.radius;
  for (const Candidate& each : best.taken) {
    samples.cloud.points.push_back(each.point);
    if (cloud.has_normals()) samples.cloud.normals.push_back(cloud.normals[each.element]);
    samples.part.push_back(0);
  }
  return samples;
}

}  // namespace

SurfaceSamples sample_surface(const DesignModel& design, std::size_t count, std::uint32_t seed,
                              const Watch& watch) {
  if (count == 0) return {};
  std::mt19937 random(seed);
  SurfaceSamples samples = design.is_cloud() ? sample_points(design, count, random, watch)
                                             : sample_mesh(design, count, random, watch);
  samples.cloud.origin = design.origin;
  return samples;
}

}  // namespace spool
