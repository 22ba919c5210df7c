// Where the next part belongs: on what was built, beside where the drawing has it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/ghost_pose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace spool::guide {
namespace {

Eigen::Matrix3d cross(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

struct Prediction {
  Pose T_design_part;
  Matrix6d covariance;
  int port = -1;  // of the part that comes
};

Vector6d small_of(const Pose& pose) {
  Vector6d small;
  small << pose.translation(), rotation_vector(pose.linear());
  return small;
}

// A neighbour known beyond doubt has no inverse: nothing is known better than a micrometre and a
// microradian.
constexpr double kSurest = 1e-6;

// The mean of poses by their information: Gauss-Newton on the small motions that are left.
Prediction mean_of(const std::vector<Prediction>& predictions) {
  Prediction mean = predictions.front();
  if (predictions.size() == 1) return mean;
  for (int round = 0; round < 10; ++round) {
    Matrix6d information = Matrix6d::Zero();
    Vector6d pull = Vector6d::Zero();
    for (const Prediction& each : predictions) {
      const Matrix6d weight = (each.covariance + kSurest * kSurest * Matrix6d::Identity())
                                  .ldlt()
                                  .solve(Matrix6d::Identity());
      information += weight;
      pull += weight * small_of(mean.T_design_part.inverse() * each.T_design_part);
    }
    const Vector6d step = information.ldlt().solve(pull);
    mean.T_design_part = mean.T_design_part * pose_from_small(step);
    mean.covariance = information.ldlt().solve(Matrix6d::Identity());
    if (step.norm() < 1e-12) break;
  }
  return mean;
}

// The standard uncertainty of |v| for a covariance of v: what is said of motions like v itself, so
// that a direction of which nothing is known hides nothing that is; of what may be chance in any
// direction, the largest there is.
double u_of_length(const Eigen::Vector3d& v, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d doubt = covariance + kSurest * kSurest * Eigen::Matrix3d::Identity();
  const double squared = v.dot(doubt.ldlt().solve(v));
  return squared <= 1 ? largest_sigma(doubt) : v.norm() / std::sqrt(squared);
}

}  // namespace

Matrix6d adjoint(const Pose& pose) {
  Matrix6d a = Matrix6d::Zero();
  a.topLeftCorner<3, 3>() = pose.linear();
  a.bottomRightCorner<3, 3>() = pose.linear();
  a.topRightCorner<3, 3>() = cross(pose.translation()) * pose.linear();
  return a;
}

std::optional<GhostPose> ghost_pose(const DesignModel& design, const AssemblyStep& step,
                                    const std::vector<BuiltPose>& built) {
  const Part& part = design.parts.at(static_cast<std::size_t>(step.part));
  std::vector<Prediction> predictions;
  for (const StepJoint& joint : step.joints) {
    const auto stands = std::find_if(built.begin(), built.end(), [&](const BuiltPose& each) {
      return each.part == joint.end.neighbour;
    });
    if (stands == built.end()) continue;
    const Part& neighbour = design.parts.at(static_cast<std::size_t>(joint.end.neighbour));
    const Pose T_neighbour_part = neighbour.T_design_part.inverse() * part.T_design_part;
    // B exp(m) R = (B R) exp(Ad(inverse(R)) m): the neighbour's doubt, seen from the ghost.
    const Matrix6d carry = adjoint(T_neighbour_part.inverse());
    predictions.push_back({stands->T_design_part * T_neighbour_part,
                           carry * stands->covariance * carry.transpose(), joint.end.port});
  }
  if (predictions.empty()) return std::nullopt;
  const Prediction mean = mean_of(predictions);
  GhostPose ghost;
  ghost.T_design_part = mean.T_design_part;
  ghost.covariance = mean.covariance;
  ghost.T_design_nominal = part.T_design_part;
  const Eigen::Vector3d port = part.ports[static_cast<std::size_t>(mean.port)].position;
  const Eigen::Matrix3d R = ghost.T_design_part.linear();
  const Eigen::Vector3d shift = ghost.T_design_part * port - ghost.T_design_nominal * port;
  ghost.distance_m = shift.norm();
  // The port moves by R (t + r x port): its covariance by that derivative.
  Eigen::Matrix<double, 3, 6> J;
  J << R, -R * cross(port);
  ghost.u_distance_m = u_of_length(shift, J * ghost.covariance * J.transpose());
  const Eigen::Vector3d turn =
      rotation_vector((ghost.T_design_nominal.inverse() * ghost.T_design_part).linear());
  ghost.angle_rad = turn.norm();
  // To first order of the turn its own covariance is that of the small rotation.
  ghost.u_angle_rad = u_of_length(turn, ghost.covariance.bottomRightCorner<3, 3>());
  for (const Prediction& a : predictions) {
    for (const Prediction& b : predictions) {
      const PoseSize apart = pose_size(a.T_design_part.inverse() * b.T_design_part);
      ghost.closure_m =
          std::max(ghost.closure_m, (a.T_design_part * port - b.T_design_part * port).norm());
      ghost.closure_rad = std::max(ghost.closure_rad, apart.rotation_rad);
    }
  }
  return ghost;
}

}  // namespace spool::guide
