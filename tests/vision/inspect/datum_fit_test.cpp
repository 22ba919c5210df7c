// The datum is followed by everything that holds it, and by nothing that is built wrong.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/datum_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/inspect/jointed_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::jointed;
using test::JointedSpool;
using test::kArm;
using test::kEnd;
using test::kFoot;
using test::kRiser;
using test::kSide;
using test::kTip;

constexpr float kVariance = 1e-6F;  // m^2: noise of 1 mm
constexpr double kDegree = std::numbers::pi / 180;
const std::vector<bool> kAll(6, true);

// Shows the fit the scan where it is now, several times over, and moves it as the fit says.
struct Followed {
  DatumFit fit;
  PointCloud scan;
  Pose T_design_scan = Pose::Identity();  // of the scan as it was given
  DatumEstimate last;

  Followed(const DesignModel& design, PointCloud of, const DatumFitOptions& options = {})
      : fit(design, options), scan(std::move(of)) {}

  // `wide_m`, `holes`: as DatumReadings.
  void see(double passed_s = 0.03, double wide_m = 0, const BoltLook* holes = nullptr) {
    const PointCloud here = spool::moved(scan, T_design_scan);
    std::vector<PointClass> classes(here.size(), PointClass::kObject);
    const Deviations deviations = measure_deviations(here, classes, jointed().surface, 0.03F);
    const std::vector<float> variances(here.size(), kVariance);
    fit.add({CloudView(here), deviations, variances, 1, passed_s, wide_m, holes});
    last = fit.solve();
    T_design_scan = moved_about(Vector3d::Zero(), last.step, T_design_scan);
    fit.follow(last.step);
  }
  void see_often(int times) {
    for (int i = 0; i < times; ++i) see();
  }
};

// How far (m) the pose puts the ends of the riser from where they belong, at most; `truth` puts the
// scan there.
double datum_off(const Pose& T, const Pose& truth) {
  double worst = 0;
  for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(0, 0, 0.8)})
    worst = std::max(worst, (T * (truth.inverse() * p) - p).norm());
  return worst;
}

Pose a_little_off() {
  Vector6d small;
  small << 0.004, -0.003, 0.002, 0.004, -0.003, 0.005;
  return pose_from_small(small);
}

TEST(DatumFit, BringsAWholeSpoolHome) {
  const PointCloud scan = jointed().scan(jointed().as_designed(), kAll);
  const Pose off = a_little_off();
  Followed followed(jointed().design, spool::moved(scan, off));
  followed.see_often(10);
  EXPECT_LT(datum_off(followed.T_design_scan, off.inverse()), 0.0003);
  for (const std::uint8_t counts : followed.last.counts) EXPECT_EQ(counts, 1);
  const double sigma = std::sqrt(followed.last.covariance.topLeftCorner<3, 3>().trace());
  EXPECT_GT(sigma, 1e-5);
  EXPECT_LT(sigma, 0.001);
}

TEST(DatumFit, WithoutDatumsTakesTheDesignForOneBody) {
  DesignModel design = jointed().design;
  design.datums.clear();
  const PointCloud scan = jointed().scan(jointed().as_designed(), kAll);
  const Pose off = a_little_off();
  Followed followed(design, spool::moved(scan, off));
  followed.see_often(5);
  EXPECT_LT(datum_off(followed.T_design_scan, off.inverse()), 0.0003);
}

// What four holes show that are turned by so much from x.
BoltLook holes_at(double angle_rad) {
  BoltLook look;
  look.bins.resize(64);
  look.pixel_m = 0.001;
  for (std::size_t i = 0; i < look.bins.size(); ++i) {
    const double angle = (static_cast<double>(i) + 0.5) / 64 * 2 * std::numbers::pi;
    const double off = std::abs(std::remainder(angle - angle_rad, std::numbers::pi / 2));
    look.bins[i] = {10, static_cast<float>(10 * std::clamp(0.5 + (0.2 - off) / 0.1, 0.0, 1.0))};
  }
  return look;
}

// All that hangs on the riser was turned about it alike: nothing but its bolt holes can tell.
TEST(DatumFit, KnowsItsTurnByItsHoles) {
  DesignModel design = jointed().design;
  design.parts[kRiser].holes = BoltHoles{4, 0.1, 0};
  Followed followed(design, jointed().scan(jointed().as_designed(), kAll));
  // In the frame of the scan as it was given; the design follows.
  for (int i = 0; i < 40; ++i) {
    const double design_turn =
        std::atan2(followed.T_design_scan.linear()(1, 0), followed.T_design_scan.linear()(0, 0));
    const BoltLook look = holes_at(5 * kDegree + design_turn);
    followed.see(0.4, 0, &look);
  }
  const Eigen::Matrix3d& turn = followed.T_design_scan.linear();
  EXPECT_NEAR(std::atan2(turn(1, 0), turn(0, 0)), -5 * kDegree, 0.2 * kDegree);
  EXPECT_EQ(followed.last.counts[kRiser], 1);
  for (const int part : {kFoot, kArm, kTip, kSide, kEnd})
    EXPECT_EQ(followed.last.counts[static_cast<std::size_t>(part)], 0);
  const double sigma = std::sqrt(followed.last.stated_covariance()(5, 5));
  EXPECT_GT(sigma, 0.1 * kDegree) << "no better than the holes tell";
  EXPECT_LT(sigma, 1 * kDegree);
}

TEST(DatumFit, KnowsItsTurnByAllThatHoldsItWhereTheHolesAgree) {
  DesignModel design = jointed().design;
  design.parts[kRiser].holes = BoltHoles{4, 0.1, 0};
  Followed followed(design, jointed().scan(jointed().as_designed(), kAll));
  const BoltLook look = holes_at(0.2 * kDegree);
  for (int i = 0; i < 40; ++i) followed.see(0.4, 0, &look);
  EXPECT_LT(pose_size(followed.T_design_scan).rotation_rad, 0.1 * kDegree);
  for (const std::uint8_t counts : followed.last.counts) EXPECT_EQ(counts, 1);
}

// The arm and its tip, half of what is seen, are turned by 5 degrees about the riser's top.
TEST(DatumFit, IsNotPulledByWhatIsBuiltWrong) {
  std::vector<Pose> built = jointed().as_designed();
  built[kArm] = built[kTip] = test::turned_about({0, 0, 0.8}, Vector3d::UnitZ(), 5);
  const PointCloud scan = jointed().scan(built, kAll);
  Followed followed(jointed().design, scan);
  followed.see_often(30);
  EXPECT_LT(datum_off(followed.T_design_scan, Pose::Identity()), 0.0003);
  EXPECT_LT(pose_size(followed.T_design_scan).rotation_rad, 0.1 * kDegree);
  EXPECT_EQ(followed.last.counts[kRiser], 1);
  EXPECT_EQ(followed.last.counts[kFoot], 1);
  EXPECT_EQ(followed.last.counts[kArm], 0);
  EXPECT_EQ(followed.last.counts[kTip], 0);
}

// Parts that are off by what the trade allows are neither an error nor a reason to follow them, as
// a best fit over everything does.
TEST(DatumFit, IsHardlyPulledByWhatIsTolerable) {
  std::vector<Pose> built = jointed().as_designed();
  built[kArm] = built[kTip] = test::moved({0, 0.003, 0});
  const PointCloud scan = jointed().scan(built, kAll);
  Followed followed(jointed().design, scan);
  followed.see_often(30);
  EXPECT_LT(datum_off(followed.T_design_scan, Pose::Identity()), 0.0004);
  EXPECT_EQ(followed.last.counts[kArm], 1);

  DesignModel rigid = jointed().design;
  rigid.datums.clear();
  Followed best_fit(rigid, scan);
  best_fit.see_often(30);
  EXPECT_GT(datum_off(best_fit.T_design_scan, Pose::Identity()), 0.0008);
}

// Where nothing but the far end is in sight, the datum is known by it as far as joints reach.
TEST(DatumFit, IsKnownThroughJointsAsFarAsTheyAllow) {
  const std::vector<bool> tip_and_arm = {false, false, true, true, false, false};
  const PointCloud scan = jointed().scan(jointed().as_designed(), tip_and_arm);
  const Pose off = a_little_off();
  Followed followed(jointed().design, spool::moved(scan, off));
  followed.see_often(30);
  EXPECT_LT(datum_off(followed.T_design_scan, off.inverse()), 0.003);
  const DatumFitOptions options;
  EXPECT_GT(std::sqrt(followed.last.covariance(5, 5)), 0.9 * options.joint_rad);
  EXPECT_LT(std::sqrt(followed.last.covariance(5, 5)), 1.5 * options.joint_rad);
}

TEST(DatumFit, KnowsOfAStraightPipeNoMoreThanItShows) {
  const std::vector<bool> riser = {true, false, false, false, false, false};
  PointCloud scan = jointed().scan(jointed().as_designed(), riser);
  PointCloud middle;  // its ends would hold it along its axis
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.points[i].z() < 0.2F || scan.points[i].z() > 0.6F) continue;
    middle.points.push_back(scan.points[i]);
    middle.normals.push_back(scan.normals[i]);
  }
  DatumFitOptions options;
  Followed followed(jointed().design, middle, options);
  followed.see_often(30);
  EXPECT_GT(std::sqrt(followed.last.covariance(2, 2)), 0.9 * options.prior_m) << "along";
  EXPECT_GT(std::sqrt(followed.last.covariance(5, 5)), 0.7 * options.prior_rad) << "about";
  EXPECT_LT(pose_size(followed.T_design_scan).translation_m, 0.001) << "nor slides";
}

// The start is what a fit to everything gives: on the arm and its tip, which are turned. Wide gates
// first let the datum's side say so.
TEST(DatumFit, LeavesAPoseThatAWrongPartHolds) {
  std::vector<Pose> built = jointed().as_designed();
  built[kArm] = built[kTip] = test::turned_about({0, 0, 0.8}, Vector3d::UnitZ(), 5);
  const Pose start = test::turned_about({0, 0, 0.8}, Vector3d::UnitZ(), -5);
  Followed followed(jointed().design, spool::moved(jointed().scan(built, kAll), start));
  for (const double wide_m : {0.03, 0.02, 0.01, 0.005, 0.0}) {
    followed.fit.clear();
    followed.see(1, wide_m);
  }
  EXPECT_LT(datum_off(followed.T_design_scan, start.inverse()), 0.0005);
  EXPECT_LT(pose_size(followed.T_design_scan * start).rotation_rad, 0.1 * kDegree);
}

// What readings err by together is not averaged away by frames from the same place.
TEST(DatumFit, IsNeverSurerThanItsReadingsErrTogether) {
  const DatumFitOptions options;
  Followed followed(jointed().design, jointed().scan(jointed().as_designed(), kAll), options);
  followed.see_often(300);
  const double sigma = std::sqrt(followed.last.covariance_as_designed(0, 0));
  EXPECT_GT(sigma, 0.2 * options.bias_m);
  EXPECT_LT(sigma, 2 * options.bias_m);
}

TEST(DatumFit, SaysWhetherTheDatumItselfTells) {
  const auto scan_of = [](const std::vector<bool>& parts) {
    return jointed().scan(jointed().as_designed(), parts);
  };
  Followed whole(jointed().design, scan_of(kAll));
  whole.see_often(30);
  EXPECT_LT(whole.last.through_joints, 0.05);
  Followed far(jointed().design, scan_of({false, false, true, true, false, false}));
  far.see_often(30);
  EXPECT_EQ(far.last.through_joints, 1);
  EXPECT_GT(far.last.stated_covariance()(5, 5), 4 * far.last.covariance_as_designed(5, 5));
}

TEST(DatumFit, ForgetsWhatIsLongPast) {
  const PointCloud scan = jointed().scan(jointed().as_designed(), kAll);
  Followed followed(jointed().design, scan);
  followed.see_often(100);
  // The map has drifted by 4 mm since: a minute later the new readings are what counts.
  followed.scan = spool::moved(scan, test::moved({0.004, 0, 0}));
  followed.see(60);
  followed.see_often(30);
  EXPECT_LT(datum_off(followed.T_design_scan, test::moved({-0.004, 0, 0})), 0.0005);
}

TEST(DatumFit, SaysNothingOfNothing) {
  DatumFit fit(jointed().design);
  const DatumEstimate estimate = fit.solve();
  EXPECT_TRUE(estimate.step.isZero());
  const DatumFitOptions options;
  EXPECT_GE(std::sqrt(estimate.covariance(0, 0)), 0.9 * options.prior_m);
  PointCloud stray;
  stray.points = {{5, 5, 5}};
  stray.normals = {{0, 0, 1}};
  fit.add({CloudView(stray), no_deviations(1), std::vector<float>{kVariance}, 1, 0.03});
  EXPECT_TRUE(fit.solve().step.isZero());
}

}  // namespace
}  // namespace spool
