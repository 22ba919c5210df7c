// What of a scan is the design, what contradicts it, and what is neither.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vision/inspect/surface_classes.h"

namespace spool {
namespace {

constexpr std::size_t kMostPieces = 4;
// A floor or a table that a spool stands on: as long as this, and as this share of the design.
constexpr double kLeastPlane_m = 1.0, kPlaneOfSize = 0.4;

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

// The scan as the chain looks at it, and where its rest stands in the scan.
struct ChainInput {
  std::vector<Eigen::Vector3f> explained, left;
  std::vector<std::int32_t> explained_part;
  std::vector<std::uint8_t> is_well;  // explained: within the chain's gate
  std::vector<std::uint32_t> explained_place, left_place;

  [[nodiscard]] ChainScan scan() const { return {explained, explained_part, is_well, left}; }
};

ChainOptions chain_options(const ExplainedDesign& design, const ExplainedScan& scan) {
  return {.noise_m = scan.noise_m,
          .size_m = design.model.bounds().diagonal().norm(),
          .least_move_m = double{deviation_bound(scan.noise_m)}};
}

// Left: the unexplained points off floor and walls that a moved piece could meet, within the
// design's own length of its middle.
ChainInput chain_input(const ExplainedDesign& design, const ExplainedScan& scan,
                       const Explanation& explanation) {
  ChainInput input;
  const Eigen::AlignedBox3d box = design.model.bounds();
  const Eigen::Vector3f middle = box.center().cast<float>();
  const auto reach = static_cast<float>(box.diagonal().norm());
  const auto band = static_cast<float>(3 * scan.noise_m);
  const double gate_m = chain_options(design, scan).gate_m();
  const std::vector<PointClass>& classes = explanation.declutter.classes;
  for (std::uint32_t i = 0; i < scan.design.size(); ++i) {
    const Eigen::Vector3f& point = scan.design.points[i];
    if (classes[i] == PointClass::kObject) {
      input.explained.push_back(point);
      input.is_well.push_back(double{std::abs(explanation.deviations.distance_m[i])} <= gate_m ? 1
                                                                                               : 0);
      input.explained_part.push_back(explanation.deviations.part[i]);
      input.explained_place.push_back(i);
      continue;
    }
    if (classes[i] != PointClass::kClutter || !((point - middle).norm() < reach)) continue;
    if (std::any_of(explanation.planes.begin(), explanation.planes.end(),
                    [&](const DominantPlane& plane) { return plane.holds(point, band); }))
      continue;
    input.left.push_back(point);
    input.left_place.push_back(i);
  }
  return input;
}

// Floor and walls, and what was scanned of them no further than the spool reaches: what is left of
// the scan holds no face of the design that could be taken for one.
std::vector<DominantPlane> planes_to_stand_on(std::span<const Eigen::Vector3f> left,
                                              const std::vector<DominantPlane>& planes,
                                              const ChainOptions& options, const Watch& watch) {
  std::vector<DominantPlane> all = planes;
  const double size_m = std::max(kLeastPlane_m, kPlaneOfSize * options.size_m);
  for (DominantPlane& plane :
       dominant_planes(left, {.size_m = size_m, .noise_m = options.noise_m}, watch))
    all.push_back(std::move(plane));
  return all;
}

// What lies on the moved piece, and on the design only because that is not sharp, is the piece's.
void take_badly_explained(double gate_m, const Deviations& deviations, Piece& piece) {
  for (const std::uint32_t i : piece.explained)
    if (double{std::abs(deviations.distance_m[i])} > gate_m) piece.points.push_back(i);
  std::sort(piece.points.begin(), piece.points.end());
}

void mark_contradicting(const ExplainedDesign& design, const ExplainedScan& scan,
                        const std::vector<std::uint32_t>& points, Explanation& explanation) {
  for (const std::uint32_t i : points) {
    explanation.declutter.classes[i] = PointClass::kContradicting;
    const auto nearest =
        design.surface.closest(scan.design.points[i], std::numeric_limits<float>::max());
    if (!nearest) continue;
    explanation.deviations.distance_m[i] = nearest->distance;
    explanation.deviations.part[i] = nearest->part;
  }
}

}  // namespace

float deviation_bound(double noise_m) { return static_cast<float>(std::max(10 * noise_m, 0.020)); }

Explanation explain_by_thesis(const ExplainedDesign& design, const ExplainedScan& scan,
                              const DeclutterOptions& options, const Watch& watch) {
  Explanation explanation;
  explanation.declutter = declutter_knn(scan.design, design.samples.cloud, options, watch);
  explanation.deviations = measure_deviations(scan.design, explanation.declutter.classes,
                                              design.surface, deviation_bound(scan.noise_m), watch);
  count_classes(explanation.declutter);
  return explanation;
}

Explanation explain_surface(const ExplainedDesign& design, const ExplainedScan& scan,
                            const Watch& watch) {
  Explanation explanation;
  const double size_m = design.model.bounds().diagonal().norm();
  explanation.planes = dominant_planes(finite(scan.design.points),
                                       {.size_m = size_m, .noise_m = scan.noise_m}, watch);
  std::vector<PointClass>& classes = explanation.declutter.classes;
  classes.assign(scan.design.size(), PointClass::kObject);
  explanation.deviations = measure_deviations(scan.design, classes, design.surface,
                                              deviation_bound(scan.noise_m), watch);
  if (watch.cancelled()) return explanation;
  classify_by_surface(scan.design, explanation.deviations, explanation.planes,
                      {.noise_m = scan.noise_m, .oriented_normals = scan.oriented_normals}, classes,
                      watch);
  forget_clutter(classes, explanation.deviations);
  count_classes(explanation.declutter);
  return explanation;
}

void explain_pieces(const ExplainedDesign& design, const ExplainedScan& scan, const Watch& watch,
                    Explanation& explanation) {
  if (watch.cancelled()) return;
  explanation.pieces =
      moved_pieces(design, scan, explanation, joint_tree(design.model), kMostPieces, watch);
  // Steel of the spool in another place is evidence, and so is steel that should not be there.
  for (Piece& piece : explanation.pieces) {
    take_badly_explained(chain_options(design, scan).gate_m(), explanation.deviations, piece);
    mark_contradicting(design, scan, piece.points, explanation);
  }
  const ChainInput input = chain_input(design, scan, explanation);
  explanation.unexpected =
      unexpected_steel(design.model, design.surface,
                       {.object = input.explained,
                        .object_part = input.explained_part,
                        .left = input.left,
                        .planes = planes_to_stand_on(input.left, explanation.planes,
                                                     chain_options(design, scan), watch),
                        .noise_m = scan.noise_m},
                       watch);
  for (Unexpected& unexpected : explanation.unexpected) {
    for (std::uint32_t& i : unexpected.points) i = input.left_place[i];
    mark_contradicting(design, scan, unexpected.points, explanation);
  }
  count_classes(explanation.declutter);
}

std::vector<Piece> moved_pieces(const ExplainedDesign& design, const ExplainedScan& scan,
                                const Explanation& explanation, std::span<const JointBranch> tree,
                                std::size_t most_pieces, const Watch& watch) {
  const ChainInput input = chain_input(design, scan, explanation);
  ChainOptions options = chain_options(design, scan);
  options.most_pieces = most_pieces;
  std::vector<Piece> pieces =
      chain_pieces(design.model, tree, design.samples, input.scan(), options, watch);
  for (Piece& piece : pieces) {
    for (std::uint32_t& i : piece.points) i = input.left_place[i];
    for (std::uint32_t& i : piece.explained) i = input.explained_place[i];
  }
  return pieces;
}

}  // namespace spool
