// The ghost of the next part against poses that were composed by hand, and its doubt against a
// sample of such poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/guide/ghost_pose.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/vision/guide/small_spool.h"
#include "vision/guide/assembly_order.h"

namespace spool::test {
namespace {

using guide::BuiltPose;
using guide::ghost_pose;

guide::AssemblyStep step_of(const DesignModel& design, const std::string& name) {
  for (const auto& step : guide::assembly_steps(design, guide::propose_order(design), {})) {
    if (design.parts[static_cast<std::size_t>(step.part)].name == name) return step;
  }
  return {};
}

const Part& part(const DesignModel& design, const char* name) {
  return design.parts[static_cast<std::size_t>(part_named(design, name))];
}

TEST(GhostPose, OnPartsAsDrawnIsTheDrawingsPlace) {
  const DesignModel design = small_spool();
  const auto ghost =
      ghost_pose(design, step_of(design, "pipe_3"),
                 {{part_named(design, "tee_1"), part(design, "tee_1").T_design_part}});
  ASSERT_TRUE(ghost);
  EXPECT_NEAR(ghost->distance_m, 0, 1e-12);
  EXPECT_NEAR(ghost->angle_rad, 0, 1e-12);
}

TEST(GhostPose, FollowsATeeThatIsRolled) {
  const DesignModel design = small_spool();
  // The tee is rolled by 10 degrees about the run (x), so its branch leans to -y.
  const double roll = 10 * M_PI / 180;
  BuiltPose tee{part_named(design, "tee_1"), part(design, "tee_1").T_design_part};
  tee.T_design_part.linear() = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto ghost = ghost_pose(design, step_of(design, "pipe_3"), {tee});
  ASSERT_TRUE(ghost);
  // By hand: the branch's end, 0.105 m from the centre, goes round the run's axis.
  const Eigen::Vector3d place(0.581, -0.105 * std::sin(roll), 0.105 * std::cos(roll));
  EXPECT_TRUE(ghost->T_design_part.translation().isApprox(place, 1e-9));
  EXPECT_NEAR(ghost->angle_rad, roll, 1e-9);
  EXPECT_NEAR(ghost->distance_m, 2 * 0.105 * std::sin(roll / 2), 1e-9);  // the chord
}

TEST(GhostPose, CarriesTheNeighboursDoubtOverTheLever) {
  const DesignModel design = small_spool();
  Matrix6d covariance = Matrix6d::Zero();
  const Vector6d u = (Vector6d() << 1e-3, 2e-3, 0.5e-3, 4e-3, 2e-3, 6e-3).finished();
  covariance.diagonal() = u.cwiseAbs2();
  covariance(0, 4) = covariance(4, 0) = 0.5 * u[0] * u[4];
  const BuiltPose elbow{part_named(design, "elbow_1"), part(design, "elbow_1").T_design_part,
                        covariance};
  const auto step = step_of(design, "pipe_4");
  const auto ghost = ghost_pose(design, step, {elbow});
  ASSERT_TRUE(ghost);
  // Poses of the elbow drawn from its covariance, each composed with the drawing.
  const Eigen::Matrix<double, 6, 6> root = covariance.llt().matrixL();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Matrix6d sampled = Matrix6d::Zero();
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    Vector6d white;
    for (int k = 0; k < 6; ++k) white[k] = normal(random);
    BuiltPose drawn = elbow;
    drawn.T_design_part = elbow.T_design_part * pose_from_small(root * white);
    const Pose off =
        ghost->T_design_part.inverse() * ghost_pose(design, step, {drawn})->T_design_part;
    Vector6d small;
    small << off.translation(), rotation_vector(off.linear());
    sampled += small * small.transpose() / kSamples;
  }
  for (int k = 0; k < 6; ++k) {
    // A variance of 20 000 draws is known to 1 %; five of that.
    EXPECT_NEAR(ghost->covariance(k, k), sampled(k, k), 0.05 * sampled(k, k)) << k;
  }
  // The lever of 152 mm makes the place less sure than the elbow's own.
  EXPECT_GT(ghost->covariance(1, 1), u[1] * u[1] + 0.9 * std::pow(0.152 * u[5], 2));
}

TEST(GhostPose, OfTwoNeighboursIsNearerTheSurerAndTellsTheClosure) {
  DesignModel design = small_spool();
  guide::AssemblyStep step = step_of(design, "pipe_1");
  ASSERT_EQ(step.joints.size(), 1u);
  guide::StepJoint other = step.joints[0];
  other.end = {1, 1, part_named(design, "tee_1"), 0};
  step.joints.push_back(other);
  BuiltPose flange{part_named(design, "flange_1"), part(design, "flange_1").T_design_part};
  BuiltPose tee{part_named(design, "tee_1"), part(design, "tee_1").T_design_part};
  flange.covariance = 1e-6 * Matrix6d::Identity();
  tee.covariance = 1e-6 * Matrix6d::Identity();
  tee.covariance.topLeftCorner<3, 3>() *= 9;  // 3 mm beside 1 mm
  tee.T_design_part.translation().x() += 0.010;
  const auto ghost = ghost_pose(design, step, {flange, tee});
  ASSERT_TRUE(ghost);
  EXPECT_NEAR(ghost->closure_m, 0.010, 1e-9);
  // Along the axis neither lever matters: weights 9 to 1, less the micrometre of the floor.
  EXPECT_NEAR(ghost->distance_m, 0.001, 2e-6);
}

TEST(GhostPose, WithoutABuiltNeighbourThereIsNone) {
  const DesignModel design = small_spool();
  EXPECT_FALSE(ghost_pose(design, step_of(design, "pipe_3"), {}));
  EXPECT_FALSE(ghost_pose(design, step_of(design, "flange_1"),
                          {{part_named(design, "pipe_4"), Pose::Identity()}}));
}

}  // namespace
}  // namespace spool::test
