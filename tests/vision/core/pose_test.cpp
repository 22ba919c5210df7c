// Laws of poses: round trips from the smallest angle to a half turn, and what is no pose.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/pose.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace spool {
namespace {

std::vector<Eigen::Vector3d> axes() {
  std::mt19937 random{1};
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> all = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
  for (int i = 0; i < 50; ++i)
    all.push_back(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized());
  return all;
}

TEST(RotationVector, ComesBackFromTheSmallestAngleToAHalfTurn) {
  constexpr double kPi = std::numbers::pi;
  for (const double angle : {1e-300, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0, 3.0, kPi - 1e-3,
                             kPi - 1e-6, kPi - 1e-9})
    for (const Eigen::Vector3d& axis : axes()) {
      const Eigen::Vector3d back = rotation_vector(rotation_from_vector(angle * axis));
      // Matrix entries are rounded to 1.1e-16 of one; small angles stand alone in theirs.
      ASSERT_LT((back - angle * axis).norm(), 1e-15 + 1e-15 * angle) << angle << " about " << axis;
      if (angle < 1e-3) {
        ASSERT_LT((back - angle * axis).norm(), 1e-12 * angle) << angle << " about " << axis;
      }
    }
}

TEST(RotationVector, IsAHalfTurnOfEitherSignAtPi) {
  for (const Eigen::Vector3d& axis : axes()) {
    const Eigen::Vector3d half_turn = std::numbers::pi * axis;
    const Eigen::Vector3d back = rotation_vector(rotation_from_vector(half_turn));
    ASSERT_LT(std::min((back - half_turn).norm(), (back + half_turn).norm()), 1e-14);
  }
  EXPECT_EQ(rotation_vector(Eigen::Matrix3d::Identity()), Eigen::Vector3d::Zero().eval());
}

TEST(RotationVector, IsRightHanded) {
  const Eigen::Vector3d turned =
      rotation_from_vector({0, 0, std::numbers::pi / 2}) * Eigen::Vector3d::UnitX();
  EXPECT_LT((turned - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

TEST(PoseFromSmall, TurnsFirstAndMovesThen) {
  Vector6d small;
  small << 1, 2, 3, 0, 0, std::numbers::pi / 2;
  const Eigen::Vector3d moved = pose_from_small(small) * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((moved - Eigen::Vector3d(1, 3, 3)).norm(), 1e-15);
  const PoseSize size = pose_size(pose_from_small(small));
  EXPECT_NEAR(size.translation_m, std::sqrt(14.0), 1e-15);
  EXPECT_NEAR(size.rotation_rad, std::numbers::pi / 2, 1e-15);
}

TEST(RowMajor, ComesBackAndIsRowMajor) {
  Vector6d small;
  small << 0.1, -2, 30, 0.5, -1, 0.25;
  const Pose pose = pose_from_small(small);
  const auto numbers = row_major(pose);
  EXPECT_EQ(numbers[3], 0.1);
  EXPECT_EQ(numbers[7], -2);
  EXPECT_EQ(numbers[11], 30);
  EXPECT_EQ(numbers[1], pose.linear()(0, 1));
  const auto back = pose_from_row_major(numbers);
  ASSERT_TRUE(back);
  EXPECT_LT((back->matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(RowMajor, MakesAPrintedRotationExactlyOrthonormal) {
  auto numbers = row_major(pose_from_small((Vector6d() << 0, 0, 0, 0.3, 0.2, -0.9).finished()));
  for (double& number : numbers) number = std::round(number * 1e5) / 1e5;  // five digits
  const auto pose = pose_from_row_major(numbers);
  ASSERT_TRUE(pose);
  const Eigen::Matrix3d r = pose->linear();
  EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
            1e-14);  // rounding
  EXPECT_NEAR(r.determinant(), 1.0, 1e-14);
}

TEST(RowMajor, RefusesWhatIsNoRigidPose) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    const char* name;
    std::vector<double> numbers;
  };
  const std::vector<Row> rows = {
      {"too few", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},
      {"none", {}},
      {"a scale", {1.01, 0, 0, 0, 0, 1.01, 0, 0, 0, 0, 1.01, 0, 0, 0, 0, 1}},
      {"a mirror", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
      {"a shear", {1, 0.01, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
      {"all zero", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
      {"column-major", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0.5, 0.5, 1}},
      {"not a number", {1, 0, 0, kNan, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
      {"infinite", {1, 0, 0, 1 / 0.0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
      {"a projection", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}}};
  for (const Row& row : rows) EXPECT_FALSE(pose_from_row_major(row.numbers)) << row.name;
}

}  // namespace
}  // namespace spool
