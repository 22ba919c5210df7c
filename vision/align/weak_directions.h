// Which motions the correspondences do not hold: sliding along a pipe, turning about it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vision/core/pose.h"

namespace spool {

// A direction of motion the data does not hold: a unit 6-vector of the motion at the design origin,
// translation over the length scale (the correspondences' RMS distance from their centre) then
// rotation.
struct WeakDirection {
  Vector6d direction = Vector6d::Zero();
  Vector6d motion =
      Vector6d::Zero();  // the same at the design origin, m and rad, unit RMS displacement
  double sigma = 0;  // m; standard deviation along it, as RMS displacement of the correspondences
  std::string text;  // "sliding along (0, 0, 1)", "turning about …"
};

// One scan point in the design frame with the surface point it is compared to.
struct Correspondence {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   // m, scan point in the design frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, of the surface
  float residual = 0;                                // m, along the normal
  float weight = 0;                                  // 0: left out
};

// Point-to-plane normal equations about `centre`: information * x = gradient for the small motion x
// (translation, rotation) of the scan. `mass` is the same sum with the whole displacement of each
// point in place of its share along the normal, over the total weight: x^T mass x is the mean
// squared displacement.
struct NormalEquations {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, weighted mean of the points
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  Matrix6d mass = Matrix6d::Identity();
  double weight = 0;            // sum of weights
  double squared_residual = 0;  // weighted sum, m^2
};

[[nodiscard]] NormalEquations build_normal_equations(std::span<const Correspondence> matches);

// The motions in the order of how well they are held: columns with unit RMS displacement (m),
// orthogonal in `mass`; `held[i]` is the information along column i, in points seen head on.
struct HeldMotions {
  Matrix6d directions = Matrix6d::Identity();
  Vector6d held = Vector6d::Zero();
  std::array<bool, 6> weak{};
};

// Solves information v = held mass v, which needs no length scale and does not mix translation with
// rotation whatever the units (the normalisation that Zhang & Singh 2016 leaves to its user). A
// motion is weak where the points that see it at more than ten degrees from their tangent plane are
// too few: a facet or a noisy normal must not pass for a hold on a round pipe.
[[nodiscard]] HeldMotions held_motions(const NormalEquations& equations,
                                       std::span<const Correspondence> matches);

// The step that solves the equations in the held motions and leaves the weak ones alone.
[[nodiscard]] Vector6d solve_held(const NormalEquations& equations, const HeldMotions& motions);

// x_there = A x_origin: the small motion of a rigid body told at `there` (m) in place of the
// origin.
[[nodiscard]] Matrix6d motion_told_at(const Eigen::Vector3d& there);

// T followed by the small motion `step` about a centre (m, in T's target frame), a rotation still.
[[nodiscard]] Pose moved_about(const Eigen::Vector3d& centre, const Vector6d& step, const Pose& T);

// Covariance (m, rad) at the design origin for residuals of `variance` (m^2) at unit weight; along
// weak motions the correspondences' RMS displacement is unknown to 10 m.
[[nodiscard]] Matrix6d motion_covariance(const NormalEquations& equations,
                                         const HeldMotions& motions, double variance);

// The information moved from the equations' centre to the design origin.
[[nodiscard]] Matrix6d information_at_origin(const NormalEquations& equations);

// What is known of a small motion at the design origin: information * motion = gradient. Sums of
// independent knowledge are knowledge.
struct MotionKnowledge {
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();

  MotionKnowledge& operator+=(const MotionKnowledge& o) {
    information += o.information;
    gradient += o.gradient;
    return *this;
  }
  MotionKnowledge& operator*=(double factor) {
    information *= factor;
    gradient *= factor;
    return *this;
  }
};
// What the held motions say, for correspondences of `variance` (m^2) at unit weight; nothing along
// the weak ones.
[[nodiscard]] MotionKnowledge held_knowledge(const NormalEquations& equations,
                                             const HeldMotions& motions, double variance);

// The weak motions told apart into slides and turns, with words.
[[nodiscard]] std::vector<WeakDirection> describe_weak(const NormalEquations& equations,
                                                       const HeldMotions& motions, double variance);

}  // namespace spool
