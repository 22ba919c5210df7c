// Which scan points are of the design's surface.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/surface_classes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vision/core/parallel.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kOnSurface = 3.5F;  // standard deviations: one reading in two thousand is further
constexpr float kAlong = 0.82F;     // cosine of 35 degrees: of a patch that runs along the surface
constexpr int kNormalNeighbours = 16;
constexpr std::size_t kPatchNeighbours = 9;  // the first is the point itself
constexpr double kMostOfPatch = 0.6;

// The points with a distance, and a normal for each (zero where there is none).
struct NearPoints {
  PointCloud cloud;
  std::vector<std::uint32_t> place;  // in the scan
};

NearPoints near_points(const CloudView& scan, const Deviations& deviations) {
  NearPoints near;
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    if (!std::isfinite(deviations.distance_m[i])) continue;
    near.place.push_back(i);
    near.cloud.points.push_back(scan.points[i]);
    if (scan.has_normals()) near.cloud.normals.push_back(scan.normals[i]);
  }
  return near;
}

}  // namespace

void classify_by_surface(const CloudView& scan_design, const Deviations& deviations,
                         std::span<const DominantPlane> planes, const SurfaceClassOptions& options,
                         std::span<PointClass> classes, const Watch& watch) {
  assert(classes.size() == scan_design.size() &&
         deviations.distance_m.size() == scan_design.size() &&
         deviations.normal.size() == scan_design.size() && "one entry a point");
  std::fill(classes.begin(), classes.end(), PointClass::kClutter);
  NearPoints near = near_points(scan_design, deviations);
  if (near.place.empty() || watch.cancelled()) return;
  const PointIndex index(near.cloud.points);
  if (!near.cloud.has_normals())
    estimate_neighbour_normals(near.cloud, index, kNormalNeighbours, std::nullopt);

  const auto noise = static_cast<float>(options.noise_m);
  // First each point by itself.
  enum class Own : std::uint8_t { kNo, kOn, kAlong };
  std::vector<Own> own(near.place.size(), Own::kNo);
  parallel_chunks(near.place.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = near.place[k];
      const Eigen::Vector3f& point = near.cloud.points[k];
      const float off = std::abs(deviations.distance_m[i]);
      // Of the floor or of the steel that stands on it: whichever is nearer.
      const float band = std::min(3 * noise, off);
      if (std::any_of(planes.begin(), planes.end(),
                      [&](const DominantPlane& plane) { return plane.holds(point, band); }))
        continue;
      const Eigen::Vector3f& n = near.cloud.normals[k];
      const bool known = n.squaredNorm() > 0.5F;
      float along = n.dot(deviations.normal[i]);
      if (!options.oriented_normals) along = std::abs(along);
      const bool is_on = off <= kOnSurface * noise;
      if (is_on)
        own[k] = Own::kOn;
      else if (known && along > kAlong)
        own[k] = Own::kAlong;
    }
  });
  // Then what lies further off: a patch, not a grain.
  parallel_chunks(near.place.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (watch.cancelled()) return;
    std::vector<Neighbour> neighbours;
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = near.place[k];
      if (own[k] == Own::kOn) classes[i] = PointClass::kObject;
      if (own[k] != Own::kAlong) continue;
      index.nearest_k(near.cloud.points[k], kPatchNeighbours, 1.0F, neighbours);
      std::size_t alike = 0;
      for (const Neighbour& neighbour : neighbours) alike += own[neighbour.index] != Own::kNo;
      if (static_cast<double>(alike) >= kMostOfPatch * static_cast<double>(neighbours.size()))
        classes[i] = PointClass::kObject;
    }
  });
}

}  // namespace spool
