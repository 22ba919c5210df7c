// Open3D's refinements: point-to-plane, plain and with Tukey's kernel, and generalised ICP.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <open3d/geometry/KDTreeFlann.h>
#include <open3d/pipelines/registration/GeneralizedICP.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/pipelines/registration/RobustKernel.h>

#include "tools/compare/contender.h"
#include "tools/compare/open3d_cloud.h"

namespace spool::compare {
namespace {

namespace registration = open3d::pipelines::registration;
using Cloud = open3d::geometry::PointCloud;

// It stops where fitness and RMSE change by less than these: never.
registration::ICPConvergenceCriteria exactly(int iterations) { return {-1.0, -1.0, iterations}; }

class Open3dIcp : public PreparedIcp {
 public:
  explicit Open3dIcp(const IcpCase& of)
      : source_(to_open3d(of.source)),
        target_(to_open3d(of.target)),
        T_guess_(of.T_guess.matrix()),
        reach_m_(of.reach_m) {}

  void build_index() override { const open3d::geometry::KDTreeFlann tree(target_); }

 protected:
  Cloud source_, target_;
  Eigen::Matrix4d T_guess_;
  double reach_m_;
};

class PointToPlane final : public Open3dIcp {
 public:
  // Tukey's width `k_m`; 0: none.
  PointToPlane(const IcpCase& of, double k_m) : Open3dIcp(of), estimation_(kernel(k_m)) {}

  Pose run(int iterations) override {
    return Pose(registration::RegistrationICP(source_, target_, reach_m_, T_guess_, estimation_,
                                              exactly(iterations))
                    .transformation_);
  }

 private:
  static std::shared_ptr<registration::RobustKernel> kernel(double k_m) {
    if (k_m > 0) return std::make_shared<registration::TukeyLoss>(k_m);
    return std::make_shared<registration::L2Loss>();
  }

  registration::TransformationEstimationPointToPlane estimation_;
};

class Generalised final : public Open3dIcp {
 public:
  explicit Generalised(const IcpCase& of) : Open3dIcp(of) {
    // Without them it estimates the source's normals in every call.
    source_.EstimateNormals(open3d::geometry::KDTreeSearchParamKNN(20));
  }

  Pose run(int iterations) override {
    return Pose(registration::RegistrationGeneralizedICP(source_, target_, reach_m_, T_guess_,
                                                         estimation_, exactly(iterations))
                    .transformation_);
  }

 private:
  registration::TransformationEstimationForGeneralizedICP estimation_;
};

}  // namespace

std::vector<IcpContender> open3d_icp() {
  return {{"Open3D point-to-plane",
           [](const IcpCase& of) { return std::make_unique<PointToPlane>(of, 0); }},
          // As wide as five deviations: wider it keeps clutter, narrower it does not get there.
          {"Open3D point-to-plane, Tukey",
           [](const IcpCase& of) { return std::make_unique<PointToPlane>(of, 5 * of.noise_m); }},
          {"Open3D generalised ICP",
           [](const IcpCase& of) { return std::make_unique<Generalised>(of); }}};
}

}  // namespace spool::compare
