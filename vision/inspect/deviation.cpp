// Signed distances of the kept points and their statistics, part by part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/deviation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "vision/core/parallel.h"
#include "vision/scan/point_index.h"
#include "vision/scan/point_spacing.h"
#include "vision/scan/spatial_order.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 2048;
constexpr std::size_t kAhead = 8;  // searches; a search takes longer than memory does

// False where it was cancelled on the way.
bool fill_with_none(std::size_t count, const Watch& watch, Deviations& deviations) {
  return watched_fill(deviations.distance_m, count, std::numeric_limits<float>::quiet_NaN(),
                      watch) &&
         watched_fill(deviations.part, count, -1, watch) &&
         watched_fill(deviations.normal, count, Eigen::Vector3f(Eigen::Vector3f::Zero()), watch);
}

// By points of the object: steel that contradicts the design lies somewhere else.
void add_coverage(const CloudView& scan, std::span<const PointClass> classes,
                  const Deviations& deviations, const SurfaceSamples& samples, const Watch& watch,
                  std::vector<PartDeviation>& parts) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> place;
  float furthest = 0;
  watched_loop(scan.size(), watch, [&](std::size_t i) {
    if (classes[i] != PointClass::kObject || deviations.part[i] < 0) return;
    points.push_back(scan.points[i]);
    place.push_back(static_cast<std::uint32_t>(i));
    furthest = std::max(furthest, std::abs(deviations.distance_m[i]));
  });
  if (points.empty()) return;
  const PointIndex index(points, watch);
  const double radius = vouching_radius(index, points, samples.radius_m);
  const auto reach = static_cast<float>(std::hypot(radius, double{furthest}));
  std::vector<std::uint8_t> seen(samples.part.size(), 0);
  parallel_chunks(samples.part.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> neighbours;
    for (std::size_t s = begin; s < end; ++s) {
      if (watch.cancelled()) return;
      index.within(samples.cloud.points[s], reach, neighbours);
      for (const Neighbour& n : neighbours) {
        const std::size_t i = place[n.index];
        if (deviations.part[i] != samples.part[s]) continue;
        // A deviating point vouches for the surface at its foot, not for where it hangs.
        const double d = deviations.distance_m[i];
        if (double{n.distance} * double{n.distance} > radius * radius + d * d) continue;
        seen[s] = 1;
        break;
      }
    }
  });
  std::vector<std::size_t> total(parts.size(), 0), covered(parts.size(), 0);
  for (std::size_t s = 0; s < samples.part.size(); ++s) {
    const auto part = static_cast<std::size_t>(samples.part[s]);
    total[part] += 1;
    covered[part] += seen[s];
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (total[p] > 0)
      parts[p].coverage = static_cast<double>(covered[p]) / static_cast<double>(total[p]);
}

}  // namespace

double vouching_radius(const PointIndex& object, const std::vector<Eigen::Vector3f>& points,
                       double sample_radius) {
  const std::size_t step = points.size() / 2000 + 1;  // two thousand say enough of a median
  if (points.empty()) return sample_radius;
  const float spacing = point_spacing(object, points, step, static_cast<float>(10 * sample_radius));
  return std::max(sample_radius, std::min(double{spacing}, 5 * sample_radius));
}

Deviations no_deviations(std::size_t scan_points) {
  Deviations deviations;
  fill_with_none(scan_points, {}, deviations);
  return deviations;
}

Deviations measure_deviations(const CloudView& scan_design, std::span<PointClass> classes,
                              const DesignSurface& surface, float max_distance,
                              const Watch& watch) {
  assert(classes.size() == scan_design.size() && "a class for every point");
  Deviations deviations;
  std::vector<std::uint32_t> kept;
  kept.reserve(scan_design.size());
  const bool prepared = fill_with_none(scan_design.size(), watch, deviations) &&
                        watched_loop(scan_design.size(), watch, [&](std::size_t i) {
                          if (classes[i] == PointClass::kClutter) return;
                          if (scan_design.points[i].allFinite())
                            kept.push_back(static_cast<std::uint32_t>(i));
                          else
                            classes[i] = PointClass::kClutter;
                        });
  if (!prepared) {
    std::fill(classes.begin(), classes.end(), PointClass::kClutter);
    return {};
  }
  // Each answer is the same in any order; in this one a search finds its triangles in the cache.
  put_in_spatial_order(scan_design.points, kept, watch);
  parallel_chunks(kept.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t n = begin; n < end; ++n) {
      const std::uint32_t i = kept[n];
      // Points visited one after the other may lie anywhere in memory: fetched ahead of their turn.
      if (n + kAhead < end) __builtin_prefetch(&scan_design.points[kept[n + kAhead]]);
      const auto hit = surface.closest(scan_design.points[i], max_distance);
      if (!hit) {
        classes[i] = PointClass::kClutter;
        continue;
      }
      deviations.distance_m[i] = hit->distance;
      deviations.part[i] = hit->part;
      deviations.normal[i] = hit->normal;
    }
  });
  // What was not come to, in the order of memory: in that of space it takes several times as long.
  if (watch.cancelled())
    parallel_chunks(classes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (deviations.part[i] < 0) classes[i] = PointClass::kClutter;
    });
  return deviations;
}

std::vector<PartDeviation> summarise_parts(const DesignModel& design, const CloudView& scan_design,
                                           std::span<const PointClass> classes,
                                           const Deviations& deviations,
                                           const SurfaceSamples& samples, const Watch& watch) {
  assert(classes.size() == scan_design.size() && deviations.part.size() == scan_design.size() &&
         "parallel arrays");
  std::vector<PartDeviation> parts(design.parts.size());
  std::vector<std::vector<float>> sizes(parts.size());
  const bool gathered = watched_loop(scan_design.size(), watch, [&](std::size_t i) {
    if (classes[i] != PointClass::kObject || deviations.part[i] < 0) return;
    const auto p = static_cast<std::size_t>(deviations.part[i]);
    const double d = deviations.distance_m[i];
    parts[p].points += 1;
    parts[p].mean_m += d;
    parts[p].rms_m += d * d;
    sizes[p].push_back(std::abs(deviations.distance_m[i]));
  });
  if (!gathered) return parts;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].points == 0) continue;
    const auto n = static_cast<double>(parts[p].points);
    parts[p].mean_m /= n;
    parts[p].rms_m = std::sqrt(parts[p].rms_m / n);
    parts[p].max_abs_m = *std::max_element(sizes[p].begin(), sizes[p].end());
    // Nearest rank: the smallest size that 95 % of the points do not exceed.
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * n)) - 1;
    std::nth_element(sizes[p].begin(), sizes[p].begin() + rank, sizes[p].end());
    parts[p].p95_abs_m = sizes[p][static_cast<std::size_t>(rank)];
  }
  add_coverage(scan_design, classes, deviations, samples, watch, parts);
  return parts;
}

double rms(const Deviations& deviations, std::span<const PointClass> classes) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < deviations.distance_m.size(); ++i) {
    const float d = deviations.distance_m[i];
    if (classes[i] != PointClass::kObject || !std::isfinite(d)) continue;
    sum += double{d} * double{d};
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));  // eq. 3.1
}

}  // namespace spool
