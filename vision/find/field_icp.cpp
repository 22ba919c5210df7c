// A quick refinement of many rough poses: point-to-plane on the field's samples.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/field_icp.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "vision/core/pose.h"

namespace spool {
namespace {

constexpr std::size_t kMostPoints = 2500;  // as many hold a pose to a fraction of their noise

struct Step {
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  double squared = 0, weight = 0;
  std::size_t inliers = 0;
};

}  // namespace

FieldIcpResult refine_on_field(std::span<const Eigen::Vector3f> scan, const CloudView& samples,
                               const SurfaceField& field, const Eigen::Isometry3f& T_guess,
                               const FieldIcpOptions& options) {
  FieldIcpResult result;
  Eigen::Isometry3d T = T_guess.cast<double>();
  // What may come near at all, once.
  std::vector<Eigen::Vector3f> near;
  for (const Eigen::Vector3f& p : scan)
    if (field.nearest(T_guess * p) != SurfaceField::kFar) near.push_back(p);
  if (near.size() > kMostPoints) {
    const std::size_t step = (near.size() + kMostPoints - 1) / kMostPoints;
    for (std::size_t i = 0; i * step < near.size(); ++i) near[i] = near[i * step];
    near.resize((near.size() + step - 1) / step);
  }
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : near) centre += (T_guess * p).cast<double>();
  if (!near.empty()) centre /= static_cast<double>(near.size());
  const Eigen::Vector3f centre_f = centre.cast<float>();
  // Rotations are counted in lengths: what they move the points by, root mean square.
  double lever = 0;
  for (const Eigen::Vector3f& p : near)
    lever += (T_guess * p - centre_f).cast<double>().squaredNorm();
  lever = near.empty() ? 1.0 : std::sqrt(lever / static_cast<double>(near.size())) + 1e-6;
  const auto per_lever = static_cast<float>(1.0 / lever);

  for (int round = 0; round <= options.iterations; ++round) {
    const double share = static_cast<double>(round) / std::max(1, options.iterations);
    const double gate = options.start_gate_m * std::pow(options.end_gate_m / options.start_gate_m,
                                                        std::min(1.0, share * 1.25));
    const auto gate_f = static_cast<float>(gate);
    const auto beside2 = static_cast<float>(4 * (gate * gate) + field.cell_m() * field.cell_m());
    Step step;
    const Eigen::Isometry3f T_f = T.cast<float>();
    Eigen::Matrix<float, 6, 6> sum = Eigen::Matrix<float, 6, 6>::Zero();
    Eigen::Matrix<float, 6, 1> right = Eigen::Matrix<float, 6, 1>::Zero();
    for (const Eigen::Vector3f& p_scan : near) {
      const Eigen::Vector3f p = T_f * p_scan;
      const std::uint16_t s = field.nearest(p);
      if (s == SurfaceField::kFar) continue;
      const Eigen::Vector3f offset = p - samples.points[s];
      const Eigen::Vector3f& n = samples.normals[s];
      const float r = n.dot(offset);
      if (std::abs(r) > gate_f || offset.squaredNorm() > beside2) continue;
      const float q = 1 - (r * r) / (gate_f * gate_f);
      const float w = q * q;  // Tukey's biweight
      Eigen::Matrix<float, 6, 1> J;
      J << n, per_lever * (p - centre_f).cross(n);
      sum.noalias() += w * J * J.transpose();
      right.noalias() -= w * r * J;
      step.squared += double{w} * double{r} * double{r};
      step.weight += w;
      ++step.inliers;
    }
    result.inliers = step.inliers;
    result.rms_m = step.weight > 0 ? std::sqrt(step.squared / step.weight) : 0;
    if (round == options.iterations || step.inliers < 6) break;
    step.information = sum.cast<double>();
    step.gradient = right.cast<double>();
    // What the points do not hold stays where it is.
    const double ridge = 0.002 * step.information.trace() / 6;
    step.information.diagonal().array() += ridge;
    Vector6d x = step.information.ldlt().solve(step.gradient);
    x.tail<3>() /= lever;
    if (!x.allFinite()) break;
    Pose motion = pose_from_small(x);
    motion.translation() += centre - motion.linear() * centre;
    T = motion * T;
    T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  }
  result.T_design_scan = T.cast<float>();
  return result;
}

}  // namespace spool
