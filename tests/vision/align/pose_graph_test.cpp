// The pose graph on loops of known truth: drift pulled out, and covariances that the errors keep
// to.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/pose_graph.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace spool {
namespace {

constexpr std::size_t kPlaces = 24;

// A keyframe of a walk round a circle of 1.5 m, looking inward.
Pose place(std::size_t i) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kPlaces;
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
  pose.translation() = Eigen::Vector3d(1.5 * std::sin(angle), 0, 1.5 * std::cos(angle));
  return pose;
}

// Not alike in all directions, and translation goes with rotation.
Matrix6d step_covariance() {
  Vector6d sigma;
  sigma << 0.0004, 0.0007, 0.0003, 0.0005, 0.0003, 0.0006;
  Matrix6d covariance = sigma.cwiseAbs2().asDiagonal();
  covariance(0, 4) = covariance(4, 0) = 0.6 * sigma[0] * sigma[4];
  return covariance;
}

struct Walk {
  std::mt19937 random;
  std::normal_distribution<double> normal;
  PoseGraph graph;

  explicit Walk(unsigned seed) : random(seed), graph(place(0), step_covariance()) {
    // The first keyframe is off as it says.
    graph = PoseGraph(place(0) * noise(), step_covariance());
    for (std::size_t i = 1; i < kPlaces; ++i)
      graph.add(i - 1, measured(i - 1, i), step_covariance());
  }
  Pose noise() {
    Vector6d unit;
    for (int k = 0; k < 6; ++k) unit[k] = normal(random);
    return pose_from_small(step_covariance().llt().matrixL() * unit);
  }
  Pose measured(std::size_t a, std::size_t b) { return place(a).inverse() * place(b) * noise(); }
  PoseEdge loop() { return {0, kPlaces - 1, measured(0, kPlaces - 1), step_covariance()}; }
  [[nodiscard]] Vector6d off(std::size_t i) const {
    return small_between(place(i), graph.T_map_keyframe(i));
  }
  // Chi-square of six degrees of freedom, where the covariance is what it says.
  [[nodiscard]] double normalised(std::size_t i) const {
    return off(i).dot(graph.covariance(i).ldlt().solve(off(i)));
  }
};

TEST(PoseGraph, TellsASmallMotionWhereItIsSeenFrom) {
  const Pose T_a_b = place(5);
  Vector6d small;
  small << 1e-4, -2e-4, 3e-4, 2e-4, 1e-4, -3e-4;
  const Vector6d there = small_between(T_a_b, pose_from_small(small) * T_a_b);
  // What is left is of second order: 3e-4 squared, times the arm.
  EXPECT_LT((there - small_seen_from(T_a_b) * small).norm(), 3e-7);
}

TEST(PoseGraph, PullsTheDriftOutWhereTheWayBegan) {
  double before = 0, after = 0, middle_before = 0, middle_after = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Walk walk(seed);
    before += walk.off(kPlaces - 1).head<3>().squaredNorm();
    middle_before += walk.off(kPlaces / 2).head<3>().squaredNorm();
    ASSERT_TRUE(walk.graph.close(walk.loop()) || seed % 20 == 0);
    walk.graph.solve();
    after += walk.off(kPlaces - 1).head<3>().squaredNorm();
    middle_after += walk.off(kPlaces / 2).head<3>().squaredNorm();
  }
  // Of 23 steps two are left at the end; in the middle half of the variance, and the arms are long.
  EXPECT_LT(after, 0.2 * before);
  EXPECT_LT(middle_after, 0.8 * middle_before);
}

// Mean of chi-square over seeds: 6 with a standard deviation of sqrt(12 / seeds). Within four.
TEST(PoseGraph, StatesCovariancesThatItsErrorsKeepTo) {
  constexpr unsigned kSeeds = 300;
  const double most_off = 4 * std::sqrt(12.0 / kSeeds);
  for (const bool is_closed : {false, true}) {
    SCOPED_TRACE(is_closed ? "closed" : "open");
    double middle = 0, end = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      Walk walk(seed);
      if (is_closed) {
        (void)walk.graph.close(walk.loop());
        walk.graph.solve();
      }
      middle += walk.normalised(kPlaces / 2) / kSeeds;
      end += walk.normalised(kPlaces - 1) / kSeeds;
    }
    EXPECT_NEAR(middle, 6, most_off);
    EXPECT_NEAR(end, 6, most_off);
  }
}

TEST(PoseGraph, PredictsWhatALoopWillMeasure) {
  constexpr unsigned kSeeds = 300;
  double mean = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    Walk walk(seed);
    mean += walk.graph.chi_square(walk.loop()) / kSeeds;
  }
  EXPECT_NEAR(mean, 6, 4 * std::sqrt(12.0 / kSeeds));
}

TEST(PoseGraph, RefusesALoopThatTheWayCannotHaveMade) {
  Walk walk(1);
  PoseEdge wrong = walk.loop();
  // The way may have drifted by 10 mm or so: the next flange of the same kind is 0.3 m away.
  wrong.T_from_to.translation().x() += 0.3;
  const Pose before = walk.graph.T_map_keyframe(kPlaces - 1);
  EXPECT_FALSE(walk.graph.close(wrong));
  walk.graph.solve();
  EXPECT_LT(pose_size(before.inverse() * walk.graph.T_map_keyframe(kPlaces - 1)).translation_m,
            1e-9);
  EXPECT_EQ(walk.graph.edge_count(), kPlaces - 1);
}

TEST(PoseGraph, KeepsPosesAndCovariancesOfTheOthersWhereOneIsTakenOut) {
  Walk walk(3);
  const Pose T_last = walk.graph.T_map_keyframe(kPlaces - 1);
  const Matrix6d covariance = walk.graph.covariance(kPlaces - 1);
  EXPECT_EQ(walk.graph.take_out(7), 6U);
  ASSERT_EQ(walk.graph.size(), kPlaces - 1);
  // The last one has the number of the one that went.
  EXPECT_LT(pose_size(T_last.inverse() * walk.graph.T_map_keyframe(7)).translation_m, 1e-12);
  // A chain that lost a link says the same of its end; the steps' first order is all that differs.
  EXPECT_LT((walk.graph.covariance(7) - covariance).norm(), 1e-3 * covariance.norm());
  walk.graph.solve();
  EXPECT_LT(pose_size(T_last.inverse() * walk.graph.T_map_keyframe(7)).translation_m, 1e-6);
}

// Looks from one place at another err together: each more says no more.
TEST(PoseGraph, LoopsBetweenTheSamePlacesCountAsOne) {
  Walk once(3), often(3), elsewhere(3);
  const PoseEdge exact{0, kPlaces - 1, place(0).inverse() * place(kPlaces - 1), step_covariance()};
  const PoseEdge back{kPlaces - 1, 0, exact.T_from_to.inverse(), step_covariance()};
  const PoseEdge across{0, kPlaces / 2, place(0).inverse() * place(kPlaces / 2), step_covariance()};
  ASSERT_TRUE(once.graph.close(exact));
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(often.graph.close(k % 2 == 0 ? exact : back));
    often.graph.solve();
  }
  ASSERT_TRUE(elsewhere.graph.close(exact));
  ASSERT_TRUE(elsewhere.graph.close(across));
  const auto sigma = [](const Walk& walk) {
    return std::sqrt(walk.graph.covariance(kPlaces / 2).topLeftCorner<3, 3>().trace());
  };
  EXPECT_NEAR(sigma(often), sigma(once), 0.01 * sigma(once));
  EXPECT_LT(sigma(elsewhere), 0.8 * sigma(once));
  once.graph.solve();
  often.graph.solve();
  const PoseSize apart = pose_size(once.graph.T_map_keyframe(kPlaces / 2).inverse() *
                                   often.graph.T_map_keyframe(kPlaces / 2));
  EXPECT_LT(apart.translation_m, 1e-5);
}

// What goes out of the graph takes nothing of what the others count for.
TEST(PoseGraph, ALoopThatGoesWithItsKeyframeIsNotCountedAnyMore) {
  const auto walk = [](bool has_second) {
    PoseGraph graph(Pose::Identity(), step_covariance());
    const Pose step(Eigen::Translation3d(0.1, 0, 0));
    for (std::size_t i = 1; i < 5; ++i) graph.add(i - 1, step, step_covariance());
    EXPECT_TRUE(!has_second || graph.close({0, 1, step, step_covariance()}));
    const Pose all(Eigen::Translation3d(0.4, 0, 0));
    EXPECT_TRUE(graph.close({0, 4, all, step_covariance()}));
    graph.take_out(1);  // hangs on 0: the loop between them says nothing any more
    return std::sqrt(graph.covariance(3).topLeftCorner<3, 3>().trace());
  };
  EXPECT_NEAR(walk(true), walk(false), 1e-6 * walk(false));
}

}  // namespace
}  // namespace spool
