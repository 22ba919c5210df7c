// Which motions the correspondences do not hold: a generalised eigenproblem, and its words.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/weak_directions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "vision/core/parallel.h"

namespace spool {
namespace {

constexpr std::size_t kGrain = 4096;
// Design tessellations turn a normal by some degrees, normals of clouds by more: what a point sees
// of a motion below ten degrees from its tangent plane may be that and nothing else.
constexpr double kTangentSine2 = 0.0302;  // sin^2(10 deg)
constexpr double kMinHeldPoints = 6;      // as many as there are motions
constexpr double kMinHeldShare = 0.002;   // of the correspondences' weight
constexpr double kClearlyHeld = 0.06;     // mean sin^2: far over the floor, no closer look needed
constexpr double kUnheldSigma = 10.0;     // m

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

struct Sums {
  double weight = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Sums& operator+=(const Sums& o) {
    weight += o.weight;
    point += o.point;
    return *this;
  }
};

struct EquationSums {
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  double squared_residual = 0;
  EquationSums& operator+=(const EquationSums& o) {
    information += o.information;
    gradient += o.gradient;
    scatter += o.scatter;
    squared_residual += o.squared_residual;
    return *this;
  }
};

std::string rounded(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string s = text;
  if (s.find('.') != std::string::npos) {
    while (s.back() == '0') s.pop_back();
    if (s.back() == '.') s.pop_back();
  }
  return s == "-0" ? "0" : s;
}

std::string triple(const Eigen::Vector3d& v, int decimals) {
  return "(" + rounded(v.x(), decimals) + ", " + rounded(v.y(), decimals) + ", " +
         rounded(v.z(), decimals) + ")";
}

// A motion and its opposite are the same motion; the larger component is made positive.
double sign_of_largest(const Eigen::Vector3d& v) {
  Eigen::Index i = 0;
  v.cwiseAbs().maxCoeff(&i);
  return v[i] < 0 ? -1.0 : 1.0;
}

std::string words(const Vector6d& motion, const Eigen::Vector3d& centre, double length) {
  const Eigen::Vector3d t = motion.head<3>();
  const Eigen::Vector3d r = motion.tail<3>();
  if (r.norm() * length < 0.05 * t.norm())
    return "sliding along " + triple(t.normalized() * sign_of_largest(t), 2);
  const Eigen::Vector3d axis = r.normalized() * sign_of_largest(r);
  const Eigen::Vector3d through = centre + r.cross(t) / r.squaredNorm();
  std::string text = "turning about " + triple(axis, 2) + " through " + triple(through, 3) + " m";
  if (std::abs(t.dot(axis)) > 0.2 * r.norm() * length) text += " while sliding along it";
  return text;
}

}  // namespace

Matrix6d motion_told_at(const Eigen::Vector3d& there) {
  Matrix6d a = Matrix6d::Identity();
  a.topRightCorner<3, 3>() = -cross_matrix(there);  // t_there = t_origin + rotation x there
  return a;
}

NormalEquations build_normal_equations(std::span<const Correspondence> matches) {
  NormalEquations equations;
  const Sums sums =
      parallel_sum(matches.size(), kGrain, Sums{}, [&](std::size_t begin, std::size_t end) {
        Sums part;
        for (std::size_t i = begin; i < end; ++i) {
          const Correspondence& m = matches[i];
          if (m.weight <= 0) continue;
          part.weight += m.weight;
          part.point += double{m.weight} * m.point.cast<double>();
        }
        return part;
      });
  equations.weight = sums.weight;
  if (sums.weight <= 0) return equations;
  equations.centre = sums.point / sums.weight;
  const EquationSums all =
      parallel_sum(matches.size(), kGrain, EquationSums{}, [&](std::size_t begin, std::size_t end) {
        EquationSums part;
        for (std::size_t i = begin; i < end; ++i) {
          const Correspondence& m = matches[i];
          if (m.weight <= 0) continue;
          const double w = m.weight;
          const Eigen::Vector3d d = m.point.cast<double>() - equations.centre;
          const Eigen::Vector3d n = m.normal.cast<double>();
          Vector6d row;
          row << n, d.cross(n);
          part.information.noalias() += (w * row) * row.transpose();
          part.gradient.noalias() -= (w * double{m.residual}) * row;
          part.scatter.noalias() += (w * d) * d.transpose();
          part.squared_residual += w * double{m.residual} * double{m.residual};
        }
        return part;
      });
  equations.information = all.information;
  equations.gradient = all.gradient;
  equations.squared_residual = all.squared_residual;
  // Mean of J^T J with J = [I, -[d]x]; the mean of d is zero.
  const Eigen::Matrix3d scatter = all.scatter / sums.weight;
  equations.mass.setIdentity();
  equations.mass.bottomRightCorner<3, 3>() =
      scatter.trace() * Eigen::Matrix3d::Identity() - scatter;
  return equations;
}

HeldMotions held_motions(const NormalEquations& equations,
                         std::span<const Correspondence> matches) {
  HeldMotions motions;
  Matrix6d mass = equations.mass;
  // Points on one line have no inertia about it: the ridge keeps that turn in, and it comes out
  // weak.
  mass.bottomRightCorner<3, 3>().diagonal().array() +=
      1e-9 + 1e-6 * mass.bottomRightCorner<3, 3>().trace();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(equations.information, mass);
  motions.directions = solver.eigenvectors();
  motions.held = solver.eigenvalues().cwiseMax(0.0);
  const double needed = std::max(kMinHeldPoints, kMinHeldShare * equations.weight);
  std::vector<int> doubtful;
  for (int i = 0; i < 6; ++i) {
    const bool clear =
        motions.held[i] > kClearlyHeld * equations.weight && motions.held[i] >= needed;
    if (!clear) doubtful.push_back(i);
  }
  if (doubtful.empty()) return motions;
  // How many points see the motion well off their tangent plane.
  const Vector6d seen = parallel_sum(
      matches.size(), kGrain, Vector6d(Vector6d::Zero()), [&](std::size_t begin, std::size_t end) {
        Vector6d part = Vector6d::Zero();
        for (std::size_t k = begin; k < end; ++k) {
          const Correspondence& m = matches[k];
          if (m.weight <= 0) continue;
          const Eigen::Vector3d d = m.point.cast<double>() - equations.centre;
          const Eigen::Vector3d n = m.normal.cast<double>();
          for (const int i : doubtful) {
            const Vector6d v = motions.directions.col(i);
            const Eigen::Vector3d u = v.head<3>() + v.tail<3>().cross(d);
            const double along = n.dot(u);
            part[i] += m.weight * std::max(0.0, along * along - kTangentSine2 * u.squaredNorm());
          }
        }
        return part;
      });
  for (const int i : doubtful) motions.weak[static_cast<std::size_t>(i)] = seen[i] < needed;
  return motions;
}

Vector6d solve_held(const NormalEquations& equations, const HeldMotions& motions) {
  Vector6d step = Vector6d::Zero();
  for (int i = 0; i < 6; ++i) {
    if (motions.weak[static_cast<std::size_t>(i)]) continue;
    const Vector6d v = motions.directions.col(i);
    step += v * (v.dot(equations.gradient) / motions.held[i]);
  }
  return step;
}

Pose moved_about(const Eigen::Vector3d& centre, const Vector6d& step, const Pose& T) {
  Pose motion = pose_from_small(step);
  motion.translation() += centre - motion.linear() * centre;
  Pose result = motion * T;
  result.linear() = Eigen::Quaterniond(result.linear()).normalized().toRotationMatrix();
  return result;
}

Matrix6d motion_covariance(const NormalEquations& equations, const HeldMotions& motions,
                           double variance) {
  Matrix6d at_centre = Matrix6d::Zero();
  for (int i = 0; i < 6; ++i) {
    const Vector6d v = motions.directions.col(i);
    const double along = motions.weak[static_cast<std::size_t>(i)] ? kUnheldSigma * kUnheldSigma
                                                                   : variance / motions.held[i];
    at_centre += along * v * v.transpose();
  }
  const Matrix6d to_origin = motion_told_at(-equations.centre);
  return to_origin * at_centre * to_origin.transpose();
}

Matrix6d information_at_origin(const NormalEquations& equations) {
  const Matrix6d a = motion_told_at(equations.centre);
  return a.transpose() * equations.information * a;
}

MotionKnowledge held_knowledge(const NormalEquations& equations, const HeldMotions& motions,
                               double variance) {
  MotionKnowledge at_centre;
  for (int i = 0; i < 6; ++i) {
    if (motions.weak[static_cast<std::size_t>(i)]) continue;
    const Vector6d v = motions.directions.col(i);
    const Vector6d row = equations.information * v / motions.held[i];
    at_centre.information += motions.held[i] / variance * row * row.transpose();
    at_centre.gradient += v.dot(equations.gradient) / variance * row;
  }
  const Matrix6d a = motion_told_at(equations.centre);
  return {a.transpose() * at_centre.information * a, a.transpose() * at_centre.gradient};
}

std::vector<WeakDirection> describe_weak(const NormalEquations& equations,
                                         const HeldMotions& motions, double variance) {
  std::vector<WeakDirection> weak;
  const auto count = std::count(motions.weak.begin(), motions.weak.end(), true);
  if (count == 0) return weak;
  const double length = std::sqrt(0.5 * equations.mass.bottomRightCorner<3, 3>().trace());
  Eigen::MatrixXd basis(6, count);
  for (int i = 0, k = 0; i < 6; ++i)
    if (motions.weak[static_cast<std::size_t>(i)]) basis.col(k++) = motions.directions.col(i);
  // Equally weak motions come out mixed; ordered by how much they turn, the pure slides fall out
  // last.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(basis.bottomRows<3>(), Eigen::ComputeFullV);
  basis = (basis * svd.matrixV()).eval();
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    const Vector6d motion = basis.col(k);  // unit RMS displacement, about the centre
    WeakDirection direction;
    direction.text = words(motion, equations.centre, length);
    const double held = motion.dot(equations.information * motion);
    direction.sigma = std::min(kUnheldSigma, std::sqrt(variance / std::max(held, 1e-12)));
    Vector6d at_origin = motion_told_at(-equations.centre) * motion;
    direction.motion = at_origin;
    at_origin.head<3>() /= std::max(length, 1e-9);
    direction.direction = at_origin.normalized();
    weak.push_back(std::move(direction));
  }
  return weak;
}

}  // namespace spool
