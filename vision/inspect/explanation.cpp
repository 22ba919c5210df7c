// What of a scan is the design, what contradicts it, and what is neither.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vision/find/dominant_planes.h"
#include "vision/inspect/surface_classes.h"

namespace spool {
namespace {

// How far (m) from the surface a point still counts as the object's. Ten standard deviations: no
// reading of the surface gets there by noise. At least 20 mm, over three times the widest tolerance
// of PFI ES-3 for a dimension (6 mm), so that an error worth a verdict is coloured and not cut
// away.
float deviation_bound(double noise_m) { return static_cast<float>(std::max(10 * noise_m, 0.020)); }

void forget_clutter(const std::vector<PointClass>& classes, Deviations& deviations) {
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] != PointClass::kClutter) continue;
    deviations.distance_m[i] = std::numeric_limits<float>::quiet_NaN();
    deviations.part[i] = -1;
  }
}

std::vector<Eigen::Vector3f> finite(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3f> some;
  some.reserve(points.size());
  for (const Eigen::Vector3f& point : points)
    if (point.allFinite()) some.push_back(point);
  return some;
}

// The unexplained points off floor and walls that a moved piece could meet: within the design's own
// length of its middle. `place`: where each stands in the scan.
void take_left(const ExplainedDesign& design, const PointCloud& scan,
               const std::vector<PointClass>& classes, const std::vector<DominantPlane>& planes,
               double noise_m, std::vector<Eigen::Vector3f>& left,
               std::vector<std::uint32_t>& place) {
  const Eigen::AlignedBox3d box = design.model.bounds();
  const Eigen::Vector3f middle = box.center().cast<float>();
  const auto reach = static_cast<float>(box.diagonal().norm());
  const auto band = static_cast<float>(3 * noise_m);
  for (std::uint32_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    if (classes[i] != PointClass::kClutter || !((point - middle).norm() < reach)) continue;
    if (std::any_of(planes.begin(), planes.end(),
                    [&](const DominantPlane& plane) { return plane.holds(point, band); }))
      continue;
    left.push_back(point);
    place.push_back(i);
  }
}

// Steel of the spool in another place is evidence: its points contradict the design.
void add_pieces(const ExplainedDesign& design, const PointCloud& scan,
                const std::vector<DominantPlane>& planes, double noise_m, const Watch& watch,
                Explanation& explanation) {
  std::vector<PointClass>& classes = explanation.declutter.classes;
  std::vector<Eigen::Vector3f> left;
  std::vector<std::uint32_t> place;
  take_left(design, scan, classes, planes, noise_m, left, place);
  ChainScan chain;
  chain.left = left;
  std::vector<Eigen::Vector3f> on;
  std::vector<std::int32_t> on_part;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (classes[i] != PointClass::kObject) continue;
    on.push_back(scan.points[i]);
    on_part.push_back(explanation.deviations.part[i]);
  }
  chain.explained = on;
  chain.explained_part = on_part;
  explanation.pieces =
      chain_pieces(design.model, design.samples, chain,
                   {.noise_m = noise_m, .size_m = design.model.bounds().diagonal().norm()}, watch);
  for (Piece& piece : explanation.pieces) {
    for (std::uint32_t& i : piece.points) {
      i = place[i];
      classes[i] = PointClass::kContradicting;
      const auto nearest =
          design.surface.closest(scan.points[i], std::numeric_limits<float>::max());
      if (!nearest) continue;
      explanation.deviations.distance_m[i] = nearest->distance;
      explanation.deviations.part[i] = nearest->part;
    }
  }
}

}  // namespace

Explanation explain_scan(const ExplainedDesign& design, const PointCloud& scan_design,
                         double noise_m, bool oriented_normals, const DeclutterOptions& options,
                         const Watch& watch) {
  Explanation explanation;
  if (options.method != DeclutterMethod::kThreeClasses || options.k > 0) {
    explanation.declutter = declutter_knn(scan_design, design.samples.cloud, options, watch);
    explanation.deviations = measure_deviations(scan_design, explanation.declutter.classes,
                                                design.surface, deviation_bound(noise_m), watch);
    count_classes(explanation.declutter);
    return explanation;
  }
  const double size_m = design.model.bounds().diagonal().norm();
  const std::vector<DominantPlane> planes =
      dominant_planes(finite(scan_design.points), {.size_m = size_m, .noise_m = noise_m}, watch);
  std::vector<PointClass>& classes = explanation.declutter.classes;
  classes.assign(scan_design.size(), PointClass::kObject);
  explanation.deviations =
      measure_deviations(scan_design, classes, design.surface, deviation_bound(noise_m), watch);
  if (watch.cancelled()) return explanation;
  classify_by_surface(scan_design, explanation.deviations, planes,
                      {.noise_m = noise_m, .oriented_normals = oriented_normals}, classes, watch);
  forget_clutter(classes, explanation.deviations);
  add_pieces(design, scan_design, planes, noise_m, watch, explanation);
  count_classes(explanation.declutter);
  return explanation;
}

}  // namespace spool
