// Open3D's global registrations: RANSAC over FPFH matches, and Fast Global Registration.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <open3d/geometry/KDTreeSearchParam.h>
#include <open3d/pipelines/registration/CorrespondenceChecker.h>
#include <open3d/pipelines/registration/FastGlobalRegistration.h>
#include <open3d/pipelines/registration/Feature.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/utility/Random.h>

#include "tools/compare/contender.h"
#include "tools/compare/open3d_cloud.h"

namespace spool::compare {
namespace {

namespace registration = open3d::pipelines::registration;
using Cloud = open3d::geometry::PointCloud;

// Radii as Open3D's own tutorial takes them: five spacings, at most 100 neighbours.
std::shared_ptr<registration::Feature> features(const Cloud& cloud, double spacing_m) {
  return registration::ComputeFPFHFeature(
      cloud, open3d::geometry::KDTreeSearchParamHybrid(5 * spacing_m, 100));
}

// Below this share of the design's points in reach of the scan the pose is not reported.
constexpr double kLeastFitness = 0.3;

// T_design_scan, refined, of T_scan_design.
std::optional<Pose> refined(const Cloud& design, const Cloud& scan, const Eigen::Matrix4d& T,
                            double spacing_m) {
  const auto icp = registration::RegistrationICP(
      design, scan, spacing_m, T, registration::TransformationEstimationPointToPlane());
  if (icp.fitness_ < kLeastFitness) return std::nullopt;
  return Pose(icp.transformation_).inverse();
}

std::optional<Pose> by_ransac(const FindCase& of) {
  open3d::utility::random::Seed(static_cast<int>(of.seed));
  const double spacing_m = 0.01 * of.size_m;
  const Cloud design = to_open3d(of.design), scan = to_open3d(of.scan);
  const registration::CorrespondenceCheckerBasedOnEdgeLength edges(0.9);
  const registration::CorrespondenceCheckerBasedOnDistance distance(1.5 * spacing_m);
  const auto found = registration::RegistrationRANSACBasedOnFeatureMatching(
      design, scan, *features(design, spacing_m), *features(scan, spacing_m), false,
      1.5 * spacing_m, registration::TransformationEstimationPointToPoint(false), 3,
      {edges, distance}, registration::RANSACConvergenceCriteria(1'000'000, 0.999));
  return refined(design, scan, found.transformation_, spacing_m);
}

std::optional<Pose> by_fgr(const FindCase& of) {
  open3d::utility::random::Seed(static_cast<int>(of.seed));
  const double spacing_m = 0.01 * of.size_m;
  const Cloud design = to_open3d(of.design), scan = to_open3d(of.scan);
  registration::FastGlobalRegistrationOption option;
  option.use_absolute_scale_ = true;
  option.maximum_correspondence_distance_ = spacing_m;
  const auto found = registration::FastGlobalRegistrationBasedOnFeatureMatching(
      design, scan, *features(design, spacing_m), *features(scan, spacing_m), option);
  return refined(design, scan, found.transformation_, spacing_m);
}

}  // namespace

std::vector<FindContender> open3d_find() {
  return {{"Open3D RANSAC-FPFH", by_ransac}, {"Open3D FGR", by_fgr}};
}

}  // namespace spool::compare
