// PCL's refinements: point-to-plane and generalised ICP.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>

#include "tools/compare/contender.h"
#include "tools/compare/pcl_cloud.h"
#include "vision/scan/normals.h"
#include "vision/scan/point_index.h"

namespace spool::compare {
namespace {

using Point = pcl::PointNormal;
using Cloud = pcl::PointCloud<Point>;

// Its point-to-plane asks for normals of both, and does not read the source's.
PointCloud with_normals(PointCloud cloud) {
  if (cloud.normals.empty())
    estimate_neighbour_normals(cloud, PointIndex(cloud.points), 16, std::nullopt);
  return cloud;
}

template <class Registration, bool is_generalised>
class PclIcp final : public PreparedIcp {
 public:
  explicit PclIcp(const IcpCase& of) : T_guess_(of.T_guess.matrix().cast<float>()) {
    registration_.setInputSource(to_pcl(with_normals(of.source)));
    registration_.setInputTarget(to_pcl(with_normals(of.target)));
    registration_.setMaxCorrespondenceDistance(of.reach_m);
    // As little as they take: it ends all the same where nothing moves to the last bit.
    registration_.setTransformationEpsilon(1e-15);
    registration_.setTransformationRotationEpsilon(is_generalised ? 1e-15 : 1.0);  // a cosine
    registration_.setEuclideanFitnessEpsilon(-1);
  }

  Pose run(int iterations) override {
    registration_.setMaximumIterations(iterations);
    Cloud moved;
    registration_.align(moved, T_guess_);
    return Pose(registration_.getFinalTransformation().template cast<double>());
  }

 private:
  Registration registration_;
  Eigen::Matrix4f T_guess_;
};

}  // namespace

std::vector<IcpContender> pcl_icp() {
  return {
      {"PCL point-to-plane",
       [](const IcpCase& of) {
         return std::make_unique<
             PclIcp<pcl::IterativeClosestPointWithNormals<Point, Point>, false>>(of);
       }},
      {"PCL generalised ICP", [](const IcpCase& of) {
         return std::make_unique<PclIcp<pcl::GeneralizedIterativeClosestPoint<Point, Point>, true>>(
             of);
       }}};
}

}  // namespace spool::compare
