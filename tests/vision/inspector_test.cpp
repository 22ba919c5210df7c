// The main path end to end on spools made from formulas: what is found, what is refused, what is
// never said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspector.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/cancelling.h"
#include "tests/vision/align/synthetic_spool.h"
#include "tests/vision/scene.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr NoiseModel kNoise{.constant_m = 0.002};

std::shared_ptr<const PreparedDesign> prepared(DesignModel model) {
  auto design = PreparedDesign::prepare(std::move(model));
  EXPECT_TRUE(design);
  return *design;
}

// Prepared once: what is prepared is immutable and shared.
std::shared_ptr<const PreparedDesign> tee_design() {
  static const auto design = prepared(test::design_of(test::tee_spool()));
  return design;
}

PointCloud cluttered_scan(const Pose& T_scan_design, std::mt19937& random) {
  PointCloud scan =
      test::scan_of(test::tee_spool(), T_scan_design,
                    {.points = 6000, .noise_m = 0.002, .towards = {0.2, 1, 0.5}}, random);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 8000; ++i) {  // the table that it stands on
    const Vector3d p(-0.6 + 1.6 * unit(random), -0.6 + 1.2 * unit(random), -0.03);
    scan.points.push_back((T_scan_design * p).cast<float>());
  }
  scan.normals.clear();
  return scan;
}

TEST(Inspector, ThreePicksOffByTenMillimetresPlaceTheSpoolAndColourIt) {
  const auto design = tee_design();
  std::mt19937 random{1};
  const Pose T_true = test::random_motion(1.2, 2.0, random);
  const PointCloud scan = cluttered_scan(T_true.inverse(), random);
  const auto pairs = test::picks_on(design->samples, T_true, 0.010, random);
  const auto found =
      Inspector(design).process(scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = pairs});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->alignment.found) << found->alignment.reason;
  EXPECT_EQ(found->alignment.pair_residual_m.size(), 3U);
  EXPECT_LT(test::pose_error(design->samples, found->alignment.T_design_scan, T_true).worst_m,
            0.002);
  ASSERT_EQ(found->scan_design.size(), scan.size());
  ASSERT_EQ(found->deviations.distance_m.size(), scan.size());
  EXPECT_EQ(found->declutter.object + found->declutter.clutter, scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const bool object = found->declutter.classes[i] == PointClass::kObject;
    EXPECT_EQ(object, std::isfinite(found->deviations.distance_m[i]));
    EXPECT_EQ(object, found->deviations.part[i] >= 0);
  }
  ASSERT_EQ(found->parts.size(), 5U);
  EXPECT_EQ(found->parts[0].status, Verdict::kSuspicious);
  EXPECT_EQ(found->status, Verdict::kSuspicious);
  for (const char* stage : {"normals", "align", "declutter", "deviation", "total"})
    EXPECT_TRUE(found->timing_s.contains(stage)) << stage;
}

TEST(Inspector, AGivenPoseIsTakenAsGiven) {
  const auto design = tee_design();
  std::mt19937 random{2};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  const Pose off(Eigen::Translation3d(0, 0.006, 0));  // seen from +y
  const auto found =
      Inspector(design).process(scan, kNoise, {.align = AlignMethod::kPose, .T_design_scan = off});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->alignment.T_design_scan.matrix(), off.matrix());
  EXPECT_GT(found->scan_rms_m, 0.003);  // 6 mm off shows
  EXPECT_TRUE(found->alignment.covariance.isZero()) << "it was given";
}

TEST(Inspector, APoseThatWasComeByOnThisScanSaysHowAndHowWell) {
  const auto design = tee_design();
  std::mt19937 random{2};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  const auto found = Inspector(design).process(scan, kNoise,
                                               {.align = AlignMethod::kPose,
                                                .T_design_scan = Pose::Identity(),
                                                .posed_by = AlignMethod::kThreePoint});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->alignment.method, AlignMethod::kThreePoint);
  EXPECT_EQ(found->alignment.T_design_scan.matrix(), Pose::Identity().matrix());
  const auto translation = found->alignment.covariance.topLeftCorner<3, 3>().diagonal();
  EXPECT_GT(translation.minCoeff(), 0);
  EXPECT_LT(translation.maxCoeff(), 0.003 * 0.003) << "thousands of points hold it";
}

TEST(Inspector, FarOffPlantCoordinatesLoseNothing) {
  std::mt19937 random{3};
  const PointCloud near_scan = cluttered_scan(Pose::Identity(), random);
  DesignModel far_model = test::design_of(test::tee_spool());
  far_model.origin = {512345.25, 4812345.5, 101.125};
  PointCloud far_scan = near_scan;
  far_scan.origin = {-3000.5, 120.25, 7.0};
  const auto near_design = tee_design();
  const auto far_design = prepared(std::move(far_model));
  const auto local = test::picks_on(near_design->samples, Pose::Identity(), 0.010, random);
  auto pairs = local;
  for (PointPair& pair : pairs) {
    pair.design += far_design->model.origin;
    pair.scan += far_scan.origin;
  }
  const auto a =
      Inspector(near_design)
          .process(near_scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = local});
  const auto b =
      Inspector(far_design)
          .process(far_scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = pairs});
  ASSERT_TRUE(a && b);
  // Doubles of 5e6 m are good to 1e-9 m.
  const Vector3d p(0.3, 0.1, 0.4);
  EXPECT_LT((b->alignment.T_design_scan * Vector3d(p + far_scan.origin) - far_design->model.origin -
             a->alignment.T_design_scan * p)
                .norm(),
            1e-6);
  EXPECT_EQ(b->scan_design.origin, far_design->model.origin);
  EXPECT_NEAR(a->scan_rms_m, b->scan_rms_m, 1e-6);
  const auto c =
      Inspector(far_design)
          .process(far_scan, kNoise,
                   {.align = AlignMethod::kPose, .T_design_scan = b->alignment.T_design_scan});
  ASSERT_TRUE(c);
  EXPECT_NEAR(c->scan_rms_m, b->scan_rms_m, 1e-6);
}

TEST(Inspector, PrincipalAxesPlaceAScanOfTheSpoolAlone) {
  const auto design = tee_design();
  std::mt19937 random{4};
  const Pose T_true = test::random_motion(1.0, 2.5, random);
  PointCloud scan = test::scan_of(test::tee_spool(), T_true.inverse(),
                                  {.points = 6000, .noise_m = 0.002}, random);
  scan.normals.clear();
  const auto found = Inspector(design).process(scan, kNoise, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->alignment.method, AlignMethod::kPrincipalAxes);
  EXPECT_TRUE(found->alignment.found) << found->alignment.reason;
  EXPECT_LT(test::pose_error(design->samples, found->alignment.T_design_scan, T_true).worst_m,
            0.001);
}

TEST(Inspector, PrincipalAxesSayThatARoomIsNotASpool) {
  const auto design = tee_design();
  std::mt19937 random{5};
  std::uniform_real_distribution<float> room(-3, 3);
  PointCloud scan = test::scan_of(test::tee_spool(), Pose::Identity(), {.points = 1000}, random);
  scan.normals.clear();
  for (int i = 0; i < 20000; ++i) scan.points.push_back({room(random), room(random), -0.5F});
  const auto found = Inspector(design).process(scan, kNoise, {});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->alignment.found);
  EXPECT_NE(found->alignment.reason.find("a scan of the spool alone"), std::string::npos);
  EXPECT_EQ(found->status, Verdict::kNotMeasured);
  EXPECT_EQ(found->declutter.clutter, scan.size());
}

TEST(Inspector, RefusedPicksStillMakeAReport) {
  const auto design = tee_design();
  std::mt19937 random{6};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  auto pairs = test::picks_on(design->samples, Pose::Identity(), 0.005, random);
  std::swap(pairs[1].scan, pairs[2].scan);
  const auto found =
      Inspector(design).process(scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = pairs});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->alignment.found);
  EXPECT_NE(found->alignment.reason.find("Picks 2 and 3 look exchanged"), std::string::npos)
      << found->alignment.reason;
  EXPECT_EQ(found->status_reason, found->alignment.reason);
  ASSERT_EQ(found->parts.size(), 5U);
  for (const PartFinding& part : found->parts) EXPECT_EQ(part.status, Verdict::kNotMeasured);
}

TEST(Inspector, FindsTheSpoolWithNoHintAndNotWhereItIsNot) {
  const auto design = PreparedDesign::prepare(test::design_of(test::tee_spool()), 1, true);
  ASSERT_TRUE(design);
  std::mt19937 random{7};
  const Pose T_true = test::random_motion(1.2, 2.0, random);
  PointCloud scan = cluttered_scan(T_true.inverse(), random);
  const auto found = Inspector(*design).process(scan, kNoise, {.align = AlignMethod::kFind});
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->alignment.found) << found->alignment.reason;
  EXPECT_LT(test::pose_error((*design)->samples, found->alignment.T_design_scan, T_true).worst_m,
            0.002);
  EXPECT_TRUE(found->timing_s.contains("find"));
  // The same table with nothing on it.
  scan.points.erase(scan.points.begin(), scan.points.begin() + 6000);
  const auto empty = Inspector(*design).process(scan, kNoise, {.align = AlignMethod::kFind});
  ASSERT_TRUE(empty);
  EXPECT_FALSE(empty->alignment.found);
  EXPECT_NE(empty->alignment.reason.find("scan"), std::string::npos);
  EXPECT_EQ(empty->declutter.object, 0U);
}

TEST(Inspector, PicksWhereNothingIsAreNotFound) {
  const auto design = tee_design();
  std::mt19937 random{8};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  const auto pairs =
      test::picks_on(design->samples, Pose(Eigen::Translation3d(0, 0, 5)), 0, random);
  const auto found =
      Inspector(design).process(scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = pairs});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->alignment.found);
  EXPECT_NE(found->alignment.reason.find("No scan point lies on the design"), std::string::npos);
}

TEST(Inspector, AStraightPipeStaysWhereItWasPutAndSaysWhy) {
  const auto design =
      prepared(test::design_of({test::Rod{{0, 0, 0}, Vector3d::UnitZ(), 0.15, 1.5}}));
  std::mt19937 random{9};
  PointCloud scan =
      test::scan_of({test::Rod{{0, 0, 0.3}, Vector3d::UnitZ(), 0.15, 0.8}}, Pose::Identity(),
                    {.points = 4000, .noise_m = 0.002, .with_ends = false}, random);
  const auto pairs = test::picks_on(design->samples, Pose::Identity(), 0.005, random);
  const auto found =
      Inspector(design).process(scan, kNoise, {.align = AlignMethod::kThreePoint, .pairs = pairs});
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->alignment.found) << found->alignment.reason;
  EXPECT_EQ(found->alignment.weak_directions.size(), 2U);
  EXPECT_NE(found->alignment.reason.find("sliding along (0, 0, 1)"), std::string::npos)
      << found->alignment.reason;
}

TEST(Inspector, KeepsNotANumberInItsPlace) {
  const auto design = tee_design();
  std::mt19937 random{10};
  PointCloud scan = cluttered_scan(Pose::Identity(), random);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scan.points[0] = {nan, nan, nan};
  scan.points[100] = {nan, 0, 0};
  const auto found = Inspector(design).process(
      scan, kNoise, {.align = AlignMethod::kPose, .T_design_scan = Pose::Identity()});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->scan_design.points[0].allFinite());
  EXPECT_FALSE(found->scan_design.points[100].allFinite());
  EXPECT_EQ(found->declutter.classes[0], PointClass::kClutter);
}

TEST(Inspector, AScanWithoutAPointIsRefused) {
  const auto design = tee_design();
  PointCloud scan;
  const auto none = Inspector(design).process(scan, kNoise, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(none.error().message, "The scan has no measured point; scan the spool again.");
  scan.points.assign(10, Eigen::Vector3f::Constant(std::nanf("")));
  EXPECT_FALSE(Inspector(design).process(scan, kNoise, {}));
}

TEST(Inspector, AFewPointsAreNoMeasurement) {
  const auto design = tee_design();
  std::mt19937 random{11};
  const PointCloud scan =
      test::scan_of(test::tee_spool(), Pose::Identity(), {.points = 40}, random);
  const auto found = Inspector(design).process(
      scan, kNoise, {.align = AlignMethod::kPose, .T_design_scan = Pose::Identity()});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, Verdict::kNotMeasured);
}

TEST(Inspector, AStopIsAnAnswerToo) {
  const auto design = tee_design();
  std::mt19937 random{12};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  std::stop_source stop;
  stop.request_stop();
  const auto found = Inspector(design).process(scan, kNoise, {}, {stop.get_token(), {}});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->alignment.found);
  EXPECT_EQ(found->alignment.reason, "The inspection was stopped before it was done.");
}

// Stopped at any stage, it says that it was, and of the parts that nothing was measured.
TEST(Inspector, AStopInTheMiddleSaysNothingOfTheParts) {
  std::mt19937 random{12};
  const PointCloud scan = cluttered_scan(Pose::Identity(), random);
  const Inspector inspector(tee_design());
  const InspectorOptions options{.align = AlignMethod::kPose, .T_design_scan = Pose::Identity()};
  const double whole_s =
      test::seconds_of([&] { EXPECT_TRUE(inspector.process(scan, kNoise, options)); });
  int stopped = 0;
  for (const double share : {0.1, 0.3, 0.5, 0.7}) {
    SCOPED_TRACE(share);
    Inspection found;
    const auto obeyed_s = test::seconds_until_obeyed(share * whole_s, [&](const Watch& watch) {
      found = *inspector.process(scan, kNoise, options, watch);
    });
    if (!obeyed_s || found.alignment.found) continue;  // it had ended, or all but
    ++stopped;
    EXPECT_NE(found.alignment.reason.find("stopped"), std::string::npos);
    EXPECT_EQ(found.declutter.clutter, scan.size());
    EXPECT_TRUE(found.deviations.distance_m.empty());
    ASSERT_EQ(found.parts.size(), 5U);
    for (const PartFinding& part : found.parts) EXPECT_EQ(part.status, Verdict::kNotMeasured);
    EXPECT_EQ(found.status, Verdict::kNotMeasured);
  }
  EXPECT_GE(stopped, 3);
}

TEST(Inspector, AGuessedUnitIsAFinding) {
  const auto design = tee_design();
  std::mt19937 random{13};
  const auto found = Inspector(design).process(
      cluttered_scan(Pose::Identity(), random), kNoise,
      {.align = AlignMethod::kPose, .T_design_scan = Pose::Identity(), .units_confirmed = false});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->findings.size(), 1U);
  EXPECT_EQ(found->findings[0].kind, "scale");
}

TEST(PreparedDesign, SamplesAndSurfaceAreWhatASensorCanSee) {
  const auto design = tee_design();
  EXPECT_LT(design->exterior.mesh.triangles.size(), design->model.mesh.triangles.size());
  const auto rods = test::tee_spool();
  for (std::size_t i = 0; i < design->samples.part.size(); ++i) {
    const Vector3d p = design->samples.cloud.points[i].cast<double>();
    for (const test::Rod& rod : rods) EXPECT_GT(test::distance_to(rod, p), -2e-3);
  }
  EXPECT_FALSE(PreparedDesign::prepare(DesignModel{}));
}

}  // namespace
}  // namespace spool
