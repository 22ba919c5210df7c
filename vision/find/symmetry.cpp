// The rigid motions that lay a design on itself, wholly or for the most part.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/symmetry.h"

#include <algorithm>
#include <cmath>

#include "vision/align/icp.h"
#include "vision/find/field_icp.h"
#include "vision/find/finder_model.h"
#include "vision/find/occupancy.h"
#include "vision/find/pose_search.h"
#include "vision/scan/thinning.h"

namespace spool {
namespace {

constexpr double kLeastShare = 0.5;
constexpr std::size_t kMost = 24;
constexpr std::size_t kPairs = 512;
constexpr double kNearlyAll = 0.95, kMayMiss = 0.002;

// The share of the samples that lie on the surface at the pose, to within a sample's spacing.
double share_on(const FinderModel& model, const std::vector<Eigen::Vector3f>& points,
                const Eigen::Isometry3f& T) {
  const auto gate = static_cast<float>(0.002 * model.size_m);
  std::size_t on = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = T * point;
    const std::uint16_t s = model.field.nearest(p);
    if (s == SurfaceField::kFar) continue;
    const Eigen::Vector3f offset = p - model.samples.points[s];
    const auto beside = static_cast<float>(model.beside_m() + 2 * model.field.cell_m());
    if (std::abs(model.samples.normals[s].dot(offset)) < gate && offset.norm() < beside) ++on;
  }
  return static_cast<double>(on) / static_cast<double>(points.size());
}

}  // namespace

std::vector<SelfLikeness> self_likenesses(const FinderModel& model, std::uint32_t seed,
                                          const Watch& watch) {
  std::vector<SelfLikeness> found;
  const std::vector<Eigen::Vector3f> thin =
      thin_to_voxels(CloudView(model.samples.points), model.cell_m()).points;
  if (thin.size() < 10) return found;
  const Occupancy occupancy(thin, model.rough_m());
  const double gate = 0.003 * model.size_m;
  for (std::size_t level = 0; level < model.levels.size(); ++level) {
    const FinderLevel& at = model.levels[level];
    // Apart, or the poses about the identity would leave no room for others.
    const std::vector<PoseHypothesis> hypotheses =
        search_poses(at.pairs, at.pairs.elements(), occupancy, model.probes,
                     {.pairs = kPairs,
                      .keep = 32,
                      .least_score = 0.5F,
                      .apart_m = static_cast<float>(model.same_m()),
                      .seed = seed + level},
                     watch);
    std::vector<Eigen::Isometry3f> tried(1, Eigen::Isometry3f::Identity());
    for (const PoseHypothesis& hypothesis : hypotheses) {
      if (watch.cancelled()) return found;
      const bool known = std::any_of(tried.begin(), tried.end(), [&](const Eigen::Isometry3f& T) {
        return displacement_m(model, T, hypothesis.T_design_scan) < model.same_m();
      });
      if (known) continue;
      tried.push_back(hypothesis.T_design_scan);
      if (tried.size() > 6 * kMost) break;
      const Eigen::Isometry3f T =
          refine_on_field(
              thin, model.samples, model.field, hypothesis.T_design_scan,
              {.iterations = 15, .start_gate_m = 1.3 * model.rough_m(), .end_gate_m = gate})
              .T_design_scan;
      const bool is_new =
          displacement_m(model, Eigen::Isometry3f::Identity(), T) > model.same_m() &&
          std::none_of(found.begin(), found.end(), [&](const SelfLikeness& other) {
            return displacement_m(model, other.motion.cast<float>(), T) < model.same_m();
          });
      const double share = is_new ? share_on(model, thin, T) : 0;
      if (share < kLeastShare) continue;
      Pose motion = T.cast<double>();
      motion.linear() = Eigen::Quaterniond(motion.linear()).normalized().toRotationMatrix();
      found.push_back({motion, share});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const SelfLikeness& a, const SelfLikeness& b) { return a.share > b.share; });
  if (found.size() > kMost) found.resize(kMost);
  return found;
}

bool lays_on_itself(const FinderModel& model, const Pose& motion) {
  return !model.probes.empty() && share_on(model, model.probes, motion.cast<float>()) >= kNearlyAll;
}

std::optional<Pose> exact_symmetry(const FinderModel& model, const DesignSurface& surface,
                                   const SelfLikeness& alike) {
  if (alike.share < kNearlyAll) return std::nullopt;
  const double exact_m = 2e-4 * model.size_m;
  const IcpResult icp = refine_icp(
      model.samples, surface, alike.motion,
      {.max_iterations = 20, .start_distance_m = 0.005 * model.size_m, .noise_m = exact_m});
  const Eigen::Isometry3f T = icp.T_design_scan.cast<float>();
  std::size_t off = 0;
  for (const Eigen::Vector3f& point : model.samples.points)
    if (!surface.closest(T * point, static_cast<float>(exact_m))) ++off;
  // A sample in a thousand may lie where a facet ends.
  if (static_cast<double>(off) > kMayMiss * static_cast<double>(model.samples.size()))
    return std::nullopt;
  return icp.T_design_scan;
}

}  // namespace spool
