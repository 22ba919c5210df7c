// The motions that a mis-turned or over-long piece suggests, and the axes they are about.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/joint_motions.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSize = 1.2;  // m, about the spool's

// A riser, and an arm that leaves it to one side and ends upright.
const std::vector<test::Rod> kRiser = {{{0, 0, 0}, Vector3d::UnitZ(), 0.03, 0.8},
                                       {{0, 0, -0.02}, Vector3d::UnitZ(), 0.07, 0.02}};
const std::vector<test::Rod> kArm = {{{0, 0, 0.8}, Vector3d::UnitX(), 0.03, 0.6},
                                     {{0.6, 0, 0.8}, Vector3d::UnitZ(), 0.03, 0.3}};
const std::vector<JointAxis> kAxes = {{{0, 0, 0.7F}, Vector3f::UnitZ()},
                                      {{0.1F, 0, 0.8F}, Vector3f::UnitX()},
                                      {{0.6F, 0, 0.9F}, Vector3f::UnitZ()}};

std::vector<Vector3f> probes() {
  std::vector<test::Rod> all = kRiser;
  all.insert(all.end(), kArm.begin(), kArm.end());
  std::mt19937 random{1};
  return test::scan_of(all, Pose::Identity(), {.points = 256}, random).points;
}

// The scan (at T_scan_design) of the riser as designed and of the arm moved by `wrong`.
Occupancy built_wrong(const Pose& T_scan_design, const Pose& wrong) {
  std::mt19937 random{2};
  auto points = test::scan_of(kRiser, T_scan_design, {.points = 2500}, random).points;
  const auto arm = test::scan_of(kArm, T_scan_design * wrong, {.points = 2500}, random).points;
  points.insert(points.end(), arm.begin(), arm.end());
  return {points, 0.015 * kSize};
}

// How near (m) any of the motions puts the arm to where it is: the worst of its far points.
double nearest(const std::vector<Eigen::Isometry3f>& motions, const Pose& T_true) {
  double least = 1e9;
  for (const Eigen::Isometry3f& T : motions) {
    double worst = 0;
    for (const Vector3d& p : {Vector3d(0.6, 0, 0.8), Vector3d(0.6, 0, 1.1), Vector3d(0.1, 0, 0.8)})
      worst = std::max(worst, (T.cast<double>() * T_true.inverse() * p - p).norm());
    least = std::min(least, worst);
  }
  return least;
}

class Turned : public testing::TestWithParam<int> {};

TEST_P(Turned, ElbowsPieceIsAmongTheMotions) {
  std::mt19937 random{3};
  const Pose T_scan_design = test::random_motion(2, 2, random);
  Pose wrong = Pose::Identity();
  wrong.linear() = Eigen::AngleAxisd(GetParam() * kDegree, Vector3d::UnitZ()).toRotationMatrix();
  const auto motions = joint_motions(kAxes, T_scan_design.inverse().cast<float>(),
                                     built_wrong(T_scan_design, wrong), probes(), 0.06 * kSize);
  // Steps of three degrees at 0.6 m: 16 mm at half a step; a refinement reaches from there.
  EXPECT_LT(nearest(motions, (T_scan_design * wrong).inverse()), 0.02) << GetParam();
  EXPECT_LE(motions.size(), kAxes.size() * 6);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Turned, testing::Values(15, 46, 90, -90, 135, 180, -31));

TEST(JointMotions, HoldThePieceBehindAPipeThatIsTooLong) {
  for (const double by : {0.03, -0.045, 0.06}) {
    Pose wrong = Pose::Identity();
    wrong.translation() = by * Vector3d::UnitZ();
    const auto motions =
        joint_motions(kAxes, Eigen::Isometry3f::Identity(), built_wrong(Pose::Identity(), wrong),
                      probes(), 0.06 * kSize);
    // Steps of 3 mm, but what is near to within 18 mm scores as well: the middle of that, less what
    // the pipe along the slide lends to either side.
    EXPECT_LT(nearest(motions, wrong.inverse()), 0.015 * kSize) << by;
  }
}

TEST(JointMotions, AreNoneOfNothing) {
  const Occupancy scan = built_wrong(Pose::Identity(), Pose::Identity());
  const Eigen::Isometry3f home = Eigen::Isometry3f::Identity();
  EXPECT_TRUE(joint_motions({}, home, scan, probes(), 0.06).empty());
  EXPECT_TRUE(joint_motions(kAxes, home, scan, {}, 0.06).empty());
  EXPECT_TRUE(joint_motions(kAxes, home, Occupancy(), probes(), 0.06).empty());
}

TEST(JointAxes, ThoseInOneLineAreGivenOnce) {
  DesignModel design = test::design_of(kRiser);
  design.parts.resize(2);
  design.parts[0].ports = {
      {"a", {0, 0, 0.8}, {0, 0, 1}}, {"b", {0, 0, 0}, {0, 0, -1}}, {"c", {0, 0, 0.4}, {1, 0, 0}}};
  design.parts[0].T_design_part.linear() =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  design.parts[0].T_design_part.translation() = Vector3d(1, 2, 3);
  for (int port = 0; port < 3; ++port) {
    Joint joint;
    joint.part_a = 0;
    joint.port_a = port;
    joint.part_b = 1;
    design.joints.push_back(joint);
  }
  const auto axes = joint_axes(design);
  ASSERT_EQ(axes.size(), 2U);
  // (0, 0, 1) turned by 90 degrees about x is (0, -1, 0).
  EXPECT_TRUE(axes[0].direction.isApprox(Vector3f(0, -1, 0), 1e-5F));
  EXPECT_TRUE(axes[0].point.isApprox(Vector3f(1, 1.2F, 3), 1e-5F));
  EXPECT_TRUE(axes[1].direction.isApprox(Vector3f(1, 0, 0), 1e-5F));
  EXPECT_TRUE(joint_axes(test::design_of(kRiser)).empty());
}

}  // namespace
}  // namespace spool
