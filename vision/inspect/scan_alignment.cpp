// From a pose, picked pairs or nothing to where the scan lies on the design, and how sure that is.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/scan_alignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vision/align/principal_axes.h"
#include "vision/core/median.h"
#include "vision/core/parallel.h"
#include "vision/find/finder.h"
#include "vision/inspect/piece_shape.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr double kPickError =
    0.010;  // m in each coordinate; a tap is off by 5-20 mm (ARCHITECTURE, Taps)
constexpr double kMinReach = 0.03, kMaxReach = 0.20;  // m
constexpr std::size_t kRefinementPoints = 30000;
constexpr int kNormalNeighbours = 12;
constexpr double kFoundReach = 0.003;  // of the size; the finder's own refinement ends nearer
constexpr double kMinOverlap =
    0.3;  // principal axes explain the object alone, not an object in a room

double corner_error(const std::vector<PointPair>& pairs, const Eigen::AlignedBox3d& bounds) {
  double worst = 0;
  for (int corner = 0; corner < 8; ++corner)
    worst = std::max(
        worst,
        predicted_error(pairs, kPickError,
                        bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  return worst;
}

PointCloud chosen_points(const PointCloud& cloud, const std::vector<std::uint32_t>& chosen) {
  PointCloud some;
  some.origin = cloud.origin;
  some.points.reserve(chosen.size());
  for (const std::uint32_t i : chosen) {
    some.points.push_back(cloud.points[i]);
    if (cloud.has_normals()) some.normals.push_back(cloud.normals[i]);
  }
  return some;
}

void take_icp(const IcpResult& icp, Alignment& alignment) {
  alignment.T_design_scan = icp.T_design_scan;
  alignment.covariance = icp.covariance;
  alignment.weak_directions = icp.weak_directions;
  alignment.rms_m = icp.rms_m;
  alignment.overlap = icp.overlap;
}

std::string what_to_mind(const IcpResult& icp) {
  std::string text;
  if (!icp.weak_directions.empty()) {
    text = "The scan does not hold the design against ";
    for (std::size_t i = 0; i < icp.weak_directions.size(); ++i)
      text += (i == 0 ? "" : ", ") + icp.weak_directions[i].text;
    text += "; there it stays where it was put first. Scan an end, a branch or a flange as well.";
  } else if (!icp.converged) {
    text = "The refinement had not settled when it ended; look at the overlay before using it.";
  }
  return text;
}

// The refinement may not carry a picked point further than a pick can be off.
bool ran_away(const Placement& placement, const IcpResult& icp, const std::vector<PointPair>& pairs,
              const Eigen::Vector3d& scan_origin) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const PointPair& pair) {
    const Eigen::Vector3d scan = pair.scan - scan_origin;
    return (icp.T_design_scan * scan - placement.T_design_scan * scan).norm() >
           PairsOptions{}.max_residual_m;
  });
}

void align_by_axes(const PointCloud& near, const DesignSurface& surface,
                   const SurfaceSamples& samples, const IcpOptions& options, const Watch& watch,
                   Alignment& alignment) {
  const PrincipalAxesResult result =
      align_principal_axes(near, samples.cloud, surface, options, watch);
  take_icp(result.best, alignment);
  alignment.ambiguous = result.ambiguous;
  for (const IcpResult& other : result.alternatives)
    alignment.alternatives.push_back(other.T_design_scan);
  if (result.best.overlap < kMinOverlap) {
    alignment.found = false;
    alignment.reason =
        "Only " + std::to_string(std::lround(100 * result.best.overlap)) +
        " % of the scan lies on the design by its principal axes; they need a scan of "
        "the spool alone. Cut the scan to the spool, or pick three pairs.";
  } else {
    alignment.reason = what_to_mind(result.best);
  }
}

void align_by_pairs(const AlignRequest& request, const Placement& placement, const PointCloud& near,
                    const DesignSurface& surface, const IcpOptions& options, const Watch& watch,
                    Alignment& alignment) {
  const IcpResult icp = refine_icp(near, surface, placement.T_design_scan, options, watch);
  take_icp(icp, alignment);
  if (icp.correspondences == 0) {
    alignment.found = false;
    alignment.reason =
        "No scan point lies on the design where the pairs put it; check that the pairs "
        "are of this scan and this design.";
  } else if (ran_away(placement, icp, request.pairs, near.origin)) {
    IcpOptions measure = options;
    measure.max_iterations = 0;
    take_icp(refine_icp(near, surface, placement.T_design_scan, measure, watch), alignment);
    alignment.covariance.setIdentity();
    alignment.covariance *= kPickError * kPickError;
    alignment.reason =
        "The refinement moved away from the picked points, so the picks' own pose is "
        "kept; pick the pairs again, nearer to where they are.";
  } else {
    alignment.reason = what_to_mind(icp);
  }
}

void place_by_finding(const AlignRequest& request, const PointCloud& scan, const Watch& watch,
                      Placement& placement) {
  assert(request.finder && "a design that is to be found was prepared for it");
  const FinderModel& finder = *request.finder;
  FindOptions options{.noise_m = placement.noise_m, .seed = request.seed};
  std::optional<Sight> sight;
  if (request.is_depth_image) options.sight = &sight.emplace(scan.points);
  const FindResult result = find_design(finder, scan.points, options, watch);
  placement.found = result.found;
  placement.reason = result.reason;
  if (!result.found) return;
  if (result.was_thinned)
    placement.reason = "The scan has " + std::to_string(result.scan_points) +
                       " points and was thinned to be searched; all of them are measured.";
  placement.T_design_scan = result.best.T_design_scan;
  // A sparse scan does not tell its own noise, its distances to the surface do.
  placement.noise_m = std::min(placement.noise_m, std::max(1.2 * result.best.scale_m, 1e-4));
  placement.reach_m = std::max(5 * placement.noise_m, kFoundReach * finder.size_m);
  placement.is_symmetric = true;
  for (const PoseEvidence& other : result.others) {
    placement.alternatives.push_back(other.T_design_scan);
    placement.is_symmetric = placement.is_symmetric &&
                             finder.are_symmetric(result.best.T_design_scan, other.T_design_scan);
  }
}

// Refines what was found, and what explains the scan as well.
void align_by_finding(const Placement& placement, const PointCloud& near,
                      const DesignSurface& surface, const SurfaceSamples& samples,
                      const IcpOptions& options, const Watch& watch, Alignment& alignment) {
  const IcpResult icp = refine_icp(near, surface, placement.T_design_scan, options, watch);
  take_icp(icp, alignment);
  if (!placement.is_held.empty()) {
    const Pose& T = placement.T_design_scan;
    const PieceShape shape(placement.is_held, samples);
    alignment.T_design_scan = shape.as_held(icp.T_design_scan * T.inverse(), placement.held_by) * T;
  }
  const std::string mind = what_to_mind(icp);
  if (!alignment.reason.empty() && !mind.empty()) alignment.reason += ' ';
  alignment.reason += mind;
  alignment.ambiguous = !placement.alternatives.empty();
  alignment.is_symmetric = placement.is_symmetric;
  alignment.alternatives = placement.alternatives;
}

}  // namespace

Placement place_scan(const AlignRequest& request, const DesignModel& design, const PointCloud& scan,
                     double noise_m, const Watch& watch) {
  const Eigen::Vector3d& scan_origin = scan.origin;
  Placement placement;
  placement.noise_m = noise_m;
  switch (request.method) {
    case AlignMethod::kPose:
      if (!request.T_design_scan) {
        placement.reason = "No pose was given; give one, or align by three pairs.";
        return placement;
      }
      placement.found = true;
      placement.reach_m = kMinReach;
      placement.T_design_scan = between_local(*request.T_design_scan, design.origin, scan_origin);
      return placement;
    case AlignMethod::kThreePoint: {
      std::vector<PointPair> local = request.pairs;
      for (PointPair& pair : local) {
        pair.design -= design.origin;
        pair.scan -= scan_origin;
      }
      const PairsAlignment pairs = align_pairs(local);
      placement.found = pairs.status == PairsStatus::kOk;
      placement.reason = pairs.reason;
      placement.pair_residual_m = pairs.residual_m;
      placement.T_design_scan = pairs.T_design_scan;
      // Two standard deviations at the far corner of the design.
      if (placement.found)
        placement.reach_m =
            std::clamp(2 * corner_error(local, design.bounds()), kMinReach, kMaxReach);
      return placement;
    }
    case AlignMethod::kPrincipalAxes:
      placement.found = true;
      return placement;
    case AlignMethod::kFind:
      place_by_finding(request, scan, watch, placement);
      return placement;
  }
  assert(false && "every method places");
  return placement;
}

PointCloud refinement_cloud(const PointCloud& scan, const DesignSurface& surface,
                            const Placement& placement) {
  std::vector<std::uint8_t> near(scan.size(), 0);
  const Eigen::Isometry3f T = placement.T_design_scan.cast<float>();
  const auto reach = static_cast<float>(2 * placement.reach_m.value_or(0.0));
  const auto is_held = [&](std::int32_t part) {
    return placement.is_held.empty() || placement.is_held[static_cast<std::size_t>(part)] != 0;
  };
  parallel_chunks(scan.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& p = scan.points[i];
      if (!p.allFinite()) continue;
      const auto closest = placement.reach_m ? surface.closest(T * p, reach) : std::nullopt;
      near[i] = !placement.reach_m || (closest && is_held(closest->part)) ? 1 : 0;
    }
  });
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (near[i] != 0) chosen.push_back(static_cast<std::uint32_t>(i));
  PointCloud cloud = chosen_points(scan, chosen);
  if (const double cell = voxel_size_for(cloud, kRefinementPoints); cell > 0)
    cloud = chosen_points(cloud, thin_to_voxels(cloud, cell).pixels);
  if (!cloud.has_normals() && !cloud.empty()) {
    const PointIndex index(cloud.points);
    estimate_neighbour_normals(cloud, index, kNormalNeighbours, std::nullopt);
  }
  return cloud;
}

double typical_noise_m(const PointCloud& scan, const NoiseModel& noise) {
  std::vector<float> depths;
  const std::size_t step = scan.size() / 10000 + 1;
  for (std::size_t i = 0; i < scan.size(); i += step)
    if (scan.points[i].allFinite()) depths.push_back(std::abs(scan.points[i].z()));
  if (depths.empty()) return noise.axial_m(1.0);
  return noise.axial_m(double{median(depths)});
}

Alignment align_scan(const AlignRequest& request, const Placement& placement,
                     const PointCloud& near, bool oriented_normals, double noise_m,
                     const DesignModel& design, const DesignSurface& surface,
                     const SurfaceSamples& samples, const Watch& watch) {
  Alignment alignment;
  alignment.method = request.method;
  alignment.found = placement.found;
  alignment.reason = placement.reason;
  alignment.pair_residual_m = placement.pair_residual_m;
  if (!placement.found) return alignment;
  IcpOptions options;
  options.noise_m = noise_m;
  options.start_distance_m = placement.reach_m.value_or(options.start_distance_m);
  options.oriented_normals = oriented_normals && !design.is_cloud();
  switch (request.method) {
    case AlignMethod::kPose: {
      options.max_iterations = 0;
      const IcpResult icp = refine_icp(near, surface, placement.T_design_scan, options, watch);
      alignment.T_design_scan = placement.T_design_scan;
      alignment.rms_m = icp.rms_m;
      alignment.overlap = icp.overlap;
      if (!request.posed_by) break;
      alignment.method = *request.posed_by;
      alignment.covariance = icp.covariance;
      alignment.weak_directions = icp.weak_directions;
      break;
    }
    case AlignMethod::kThreePoint:
      align_by_pairs(request, placement, near, surface, options, watch, alignment);
      break;
    case AlignMethod::kPrincipalAxes:
      align_by_axes(near, surface, samples, options, watch, alignment);
      break;
    case AlignMethod::kFind:
      align_by_finding(placement, near, surface, samples, options, watch, alignment);
      break;
  }
  if (watch.cancelled()) mark_stopped(alignment);
  alignment.T_design_scan = between_files(alignment.T_design_scan, design.origin, near.origin);
  for (Pose& other : alignment.alternatives)
    other = between_files(other, design.origin, near.origin);
  return alignment;
}

void mark_stopped(Alignment& alignment) {
  alignment.found = false;
  alignment.reason = "The inspection was stopped before it was done.";
}

Pose between_files(const Pose& T_design_scan, const Eigen::Vector3d& design_origin,
                   const Eigen::Vector3d& scan_origin) {
  Pose T = T_design_scan;
  T.translation() += design_origin - T.linear() * scan_origin;
  return T;
}

Pose between_local(const Pose& T_design_scan, const Eigen::Vector3d& design_origin,
                   const Eigen::Vector3d& scan_origin) {
  Pose T = T_design_scan;
  T.translation() += T.linear() * scan_origin - design_origin;
  return T;
}

PointCloud to_design_frame(const PointCloud& scan, const DesignModel& design,
                           const Pose& T_design_scan) {
  PointCloud moved = scan;
  moved.origin = design.origin;
  const Pose T = between_local(T_design_scan, design.origin, scan.origin);
  const Eigen::Matrix3f turn = T.linear().cast<float>();
  parallel_chunks(scan.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      moved.points[i] = (T * scan.points[i].cast<double>()).cast<float>();  // NaN stays NaN
      if (scan.has_normals()) moved.normals[i] = turn * scan.normals[i];
    }
  });
  return moved;
}

}  // namespace spool
