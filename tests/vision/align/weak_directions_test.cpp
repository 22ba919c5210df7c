// The normal equations against numeric derivatives, and the motions they hold.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/weak_directions.h"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace spool {
namespace {

std::vector<Correspondence> random_matches(std::size_t count) {
  std::mt19937 random{1};
  std::normal_distribution<float> gauss(0, 1);
  std::vector<Correspondence> matches(count);
  for (Correspondence& m : matches) {
    m.point = Eigen::Vector3f(3 + gauss(random), gauss(random), -2 + gauss(random));
    m.normal = Eigen::Vector3f(gauss(random), gauss(random), gauss(random)).normalized();
    m.residual = 0.01F * gauss(random);
    m.weight = 0.1F + std::abs(gauss(random));
  }
  matches[3].weight = 0;
  return matches;
}

// The weighted sum of squares after the points are moved by x about `centre`, surfaces staying
// planes.
double cost(const std::vector<Correspondence>& matches, const Eigen::Vector3d& centre,
            const Vector6d& x) {
  const Pose motion = pose_from_small(x);
  double sum = 0;
  for (const Correspondence& m : matches) {
    const Eigen::Vector3d d = m.point.cast<double>() - centre;
    const Eigen::Vector3d moved = motion * d - d;
    const double r = double{m.residual} + m.normal.cast<double>().dot(moved);
    sum += double{m.weight} * r * r;
  }
  return 0.5 * sum;
}

TEST(NormalEquations, GradientAndInformationAreTheDerivativesOfTheCost) {
  const auto matches = random_matches(200);
  const NormalEquations equations = build_normal_equations(matches);
  constexpr double kStep = 1e-4;
  for (int i = 0; i < 6; ++i) {
    Vector6d step = Vector6d::Zero();
    step[i] = kStep;
    const double slope =
        (cost(matches, equations.centre, step) - cost(matches, equations.centre, -step)) /
        (2 * kStep);
    // Central differences are good to the square of the step.
    EXPECT_NEAR(-equations.gradient[i], slope, 1e-5) << i;
    const double bend =
        (cost(matches, equations.centre, step) + cost(matches, equations.centre, -step) -
         2 * cost(matches, equations.centre, Vector6d::Zero())) /
        (kStep * kStep);
    // The residuals' own curvature (1 cm times the lever arm) is what Gauss-Newton leaves out.
    EXPECT_NEAR(equations.information(i, i), bend, 0.05 * equations.information(i, i)) << i;
  }
}

TEST(NormalEquations, MassIsTheMeanSquaredDisplacement) {
  const auto matches = random_matches(200);
  const NormalEquations equations = build_normal_equations(matches);
  Vector6d x;
  x << 0.3, -0.2, 0.1, 0.05, -0.4, 0.2;
  double sum = 0, weight = 0;
  for (const Correspondence& m : matches) {
    const Eigen::Vector3d d = m.point.cast<double>() - equations.centre;
    sum += double{m.weight} * (x.head<3>() + x.tail<3>().cross(d)).squaredNorm();
    weight += double{m.weight};
  }
  EXPECT_NEAR(x.dot(equations.mass * x), sum / weight, 1e-9);
  EXPECT_NEAR(equations.weight, weight, 1e-9);
}

TEST(HeldMotions, SolveIsTheNewtonStepWhereAllIsHeld) {
  const auto matches = random_matches(200);
  const NormalEquations equations = build_normal_equations(matches);
  const HeldMotions motions = held_motions(equations, matches);
  const Vector6d newton = equations.information.lu().solve(equations.gradient);
  EXPECT_TRUE(solve_held(equations, motions).isApprox(newton, 1e-5));
  for (const bool weak : motions.weak) EXPECT_FALSE(weak);
}

TEST(HeldMotions, CovarianceIsTheInverseOfTheInformationAtTheOrigin) {
  const auto matches = random_matches(200);
  const NormalEquations equations = build_normal_equations(matches);
  const HeldMotions motions = held_motions(equations, matches);
  const Matrix6d product =
      motion_covariance(equations, motions, 4.0) * information_at_origin(equations);
  EXPECT_TRUE(product.isApprox(4.0 * Matrix6d::Identity(), 1e-4));
}

TEST(HeldMotions, FacetsDoNotHoldARoundPipe) {
  // Normals of a 48-sided pipe turn by up to 3.75 degrees off the radius: no hold on a turn.
  std::vector<Correspondence> matches;
  for (int i = 0; i < 4000; ++i) {
    const double angle = 0.01 * i, z = 0.0005 * i;
    const double facet = std::round(angle / (M_PI / 24)) * (M_PI / 24);
    Correspondence m;
    m.point = Eigen::Vector3d(0.05 * std::cos(angle), 0.05 * std::sin(angle), z).cast<float>();
    m.normal = Eigen::Vector3d(std::cos(facet), std::sin(facet), 0).cast<float>();
    m.weight = 1;
    matches.push_back(m);
  }
  const NormalEquations equations = build_normal_equations(matches);
  const HeldMotions motions = held_motions(equations, matches);
  EXPECT_EQ(std::count(motions.weak.begin(), motions.weak.end(), true), 2);
  const auto words = describe_weak(equations, motions, 1e-6);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(words[0].text, "turning about (0, 0, 1) through (0, 0, 1) m");
  EXPECT_EQ(words[1].text, "sliding along (0, 0, 1)");
  // Ten more points that look along the pipe hold the slide.
  for (int i = 0; i < 10; ++i)
    matches.push_back({{0.0F, 0.03F, 2.0F}, Eigen::Vector3f::UnitZ(), 0.0F, 1.0F});
  const NormalEquations more = build_normal_equations(matches);
  EXPECT_EQ(describe_weak(more, held_motions(more, matches), 1e-6).size(), 1U);
}

}  // namespace
}  // namespace spool
