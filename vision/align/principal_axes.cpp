// Coarse registration by principal axes: every proper permutation tried, refined, compared.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/principal_axes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kCoarsePoints = 1500;  // enough to tell 24 orientations apart
constexpr std::size_t kFinished = 6;         // best combinations refined with all points
constexpr double kKept = 0.9;                // share of the points that the trimmed error counts

struct Axes {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  // columns, largest spread first, right-handed
  double size_m = 0;                // RMS distance from the centre
};

std::vector<std::uint32_t> finite_points(const CloudView& cloud, std::size_t at_most) {
  std::vector<std::uint32_t> finite;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.points[i].allFinite()) finite.push_back(static_cast<std::uint32_t>(i));
  if (finite.size() <= at_most) return finite;
  std::vector<std::uint32_t> some;
  for (std::size_t k = 0; k < at_most; ++k) some.push_back(finite[k * finite.size() / at_most]);
  return some;
}

Axes principal_axes(const CloudView& cloud) {
  Axes axes;
  std::size_t count = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    axes.centre += p.cast<double>();
    ++count;
  }
  if (count == 0) return axes;
  axes.centre /= static_cast<double>(count);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3d d = p.cast<double>() - axes.centre;
    scatter += d * d.transpose();
  }
  scatter /= static_cast<double>(count);
  axes.size_m = std::sqrt(scatter.trace());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  axes.axes = solver.eigenvectors().rowwise().reverse();
  if (axes.axes.determinant() < 0) axes.axes.col(2) *= -1;
  return axes;
}

// The 24 rotations that take the coordinate axes onto each other.
std::vector<Eigen::Matrix3d> proper_permutations() {
  std::vector<Eigen::Matrix3d> all;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 3; ++i)
        m(i, order[static_cast<std::size_t>(i)]) = ((signs >> i) & 1) != 0 ? -1.0 : 1.0;
      if (m.determinant() > 0) all.push_back(m);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

// Mean distance (m) of the nearest 90 % of the points to the surface; what is beyond `bound` counts
// as it.
double trimmed_error(const CloudView& scan, const std::vector<std::uint32_t>& chosen,
                     const DesignSurface& surface, const Pose& T, double bound) {
  if (chosen.empty()) return bound;
  std::vector<double> distances(chosen.size(), bound);
  const Eigen::Isometry3f T_f = T.cast<float>();
  parallel_chunks(chosen.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      if (const auto hit = surface.closest(T_f * scan.points[chosen[k]], static_cast<float>(bound)))
        distances[k] = std::min(bound, std::abs(double{hit->distance}));
  });
  std::sort(distances.begin(), distances.end());
  const auto kept = std::max<std::size_t>(
      1, static_cast<std::size_t>(kKept * static_cast<double>(distances.size())));
  double sum = 0;
  for (std::size_t k = 0; k < kept; ++k) sum += distances[k];
  return sum / static_cast<double>(kept);
}

PointCloud chosen_cloud(const CloudView& scan, const std::vector<std::uint32_t>& chosen) {
  PointCloud cloud;
  for (const std::uint32_t i : chosen) {
    cloud.points.push_back(scan.points[i]);
    if (scan.has_normals()) cloud.normals.push_back(scan.normals[i]);
  }
  return cloud;
}

struct Candidate {
  IcpResult icp;
  double error_m = 0;
};

// How far (m, RMS over the design) two poses are apart, motions that neither holds left out: a pipe
// turned about itself is the same answer.
double apart(const IcpResult& a, const IcpResult& b, const Axes& design) {
  const Pose between = a.T_design_scan * b.T_design_scan.inverse();
  // Twist of the motion between: exact for slides and for turns about any axis.
  const Eigen::Vector3d turn = rotation_vector(between.linear());
  const double angle = turn.norm();
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  k << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(), 0;
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity() + 0.5 * k;
  if (angle > 1e-6)
    left = Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / (angle * angle) * k +
           (angle - std::sin(angle)) / (angle * angle * angle) * k * k;
  Vector6d twist;
  twist << left.fullPivLu().solve(between.translation()), turn;
  // Displacements at six points that have the design's spread stand for the whole of it.
  Eigen::Matrix<double, 18, 6> jacobian;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d p =
        design.centre + ((i & 1) != 0 ? -1.0 : 1.0) * design.size_m * design.axes.col(i / 2);
    Eigen::Matrix3d cross;
    cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
    jacobian.block<3, 3>(3 * i, 0).setIdentity();
    jacobian.block<3, 3>(3 * i, 3) = -cross;
  }
  Eigen::VectorXd moved = jacobian * twist;
  if (!a.weak_directions.empty()) {
    Eigen::MatrixXd weak(18, static_cast<Eigen::Index>(a.weak_directions.size()));
    for (std::size_t i = 0; i < a.weak_directions.size(); ++i)
      weak.col(static_cast<Eigen::Index>(i)) = jacobian * a.weak_directions[i].motion;
    moved -= weak * weak.colPivHouseholderQr().solve(moved);
  }
  return moved.norm() / std::sqrt(6.0);
}

}  // namespace

PrincipalAxesResult align_principal_axes(const CloudView& scan, const CloudView& design,
                                         const DesignSurface& surface, const IcpOptions& options,
                                         const Watch& watch) {
  assert(!validate(options) && "options as validate() accepts them");
  PrincipalAxesResult result;
  const Axes scan_axes = principal_axes(scan);
  const Axes design_axes = principal_axes(design);
  const std::vector<std::uint32_t> chosen = finite_points(scan, kCoarsePoints);
  const PointCloud coarse = chosen_cloud(scan, chosen);
  const std::vector<Eigen::Matrix3d> permutations = proper_permutations();
  result.combinations = static_cast<int>(permutations.size());

  // A scan of one side has its centre and axes off by a fair share of the size.
  const double bound = std::max(options.start_distance_m, 0.25 * design_axes.size_m);
  IcpOptions rough = options;
  rough.start_distance_m = bound;
  rough.noise_m = std::max(options.noise_m, 0.02 * design_axes.size_m);
  rough.max_iterations = 25;
  std::vector<Candidate> candidates;
  for (const Eigen::Matrix3d& permutation : permutations) {
    if (watch.cancelled()) break;
    Pose T = Pose::Identity();
    T.linear() = design_axes.axes * permutation * scan_axes.axes.transpose();
    T.translation() = design_axes.centre - T.linear() * scan_axes.centre;
    Candidate candidate;
    candidate.icp = refine_icp(coarse, surface, T, rough, {watch.stop, {}});
    candidate.error_m = trimmed_error(scan, chosen, surface, candidate.icp.T_design_scan, bound);
    candidates.push_back(std::move(candidate));
    watch.report("align", static_cast<double>(candidates.size()) / 30.0);
  }
  const auto better = [](const Candidate& a, const Candidate& b) { return a.error_m < b.error_m; };
  std::stable_sort(candidates.begin(), candidates.end(), better);
  candidates.resize(std::min(candidates.size(), kFinished));

  IcpOptions fine = options;
  fine.start_distance_m = std::max(options.start_distance_m, 4 * rough.noise_m);
  for (Candidate& candidate : candidates) {
    if (watch.cancelled()) break;
    candidate.icp = refine_icp(scan, surface, candidate.icp.T_design_scan, fine, {watch.stop, {}});
    candidate.error_m = trimmed_error(scan, chosen, surface, candidate.icp.T_design_scan, bound);
  }
  std::stable_sort(candidates.begin(), candidates.end(), better);
  if (candidates.empty()) return result;
  result.best = candidates.front().icp;
  if (result.best.correspondences == 0) return result;
  result.best.converged = result.best.converged && !watch.cancelled();

  // Ends as well: the mean distances differ by less than a tenth, or than a tenth of the noise.
  const double best_error = candidates.front().error_m;
  const double limit = best_error + 0.1 * std::max(best_error, options.noise_m);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (candidates[i].error_m > limit) break;
    const double same = 6 * options.noise_m;
    bool known = apart(result.best, candidates[i].icp, design_axes) < same;
    for (const IcpResult& other : result.alternatives)
      known = known || apart(other, candidates[i].icp, design_axes) < same;
    if (!known) result.alternatives.push_back(candidates[i].icp);
  }
  result.ambiguous = !result.alternatives.empty();
  return result;
}

}  // namespace spool
