// Tests of the measures: by hand on small counts, against shapes whose distances are known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/measures.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

TEST(Measures, AreTheRatiosThatTheirEquationsSay) {
  // Ten points, five of the object; four kept, three of them rightly.
  const std::vector<std::uint8_t> object = {1, 1, 1, 1, 1, 0, 0, 0, 0, 0};
  const std::vector<std::uint8_t> kept = {1, 1, 1, 0, 0, 1, 0, 0, 0, 0};
  const KeptCounts counts = count_kept(object, kept);
  EXPECT_EQ(counts.object, 5U);
  EXPECT_EQ(counts.kept, 4U);
  EXPECT_EQ(counts.true_kept, 3U);
  EXPECT_DOUBLE_EQ(recognition_rate(counts), 0.6);
  EXPECT_DOUBLE_EQ(void_rate(counts), 0.4);
  EXPECT_DOUBLE_EQ(noise_rate(counts), 0.2);
  EXPECT_DOUBLE_EQ(void_rate_as_printed(counts), 0.5);
  EXPECT_DOUBLE_EQ(noise_rate_as_printed(counts), 0.25);
  EXPECT_DOUBLE_EQ(precision(counts), 0.75);
  EXPECT_DOUBLE_EQ(recall(counts), 0.6);
  EXPECT_DOUBLE_EQ(f1(counts), 2 * 0.75 * 0.6 / (0.75 + 0.6));
  EXPECT_DOUBLE_EQ(density_ratio(50000, 10000), 5);
  EXPECT_DOUBLE_EQ(clutter_ratio(60, 20), 2);
  EXPECT_DOUBLE_EQ(completeness_ratio(18, 20), 0.9);
  EXPECT_DOUBLE_EQ(effectiveness_ratio(11, 12), 11.0 / 12);
}

TEST(Measures, OfNothingAreNotANumber) {
  const KeptCounts none = count_kept({}, {});
  for (const auto measure : {recognition_rate, void_rate, noise_rate, void_rate_as_printed,
                             noise_rate_as_printed, precision, recall, f1})
    EXPECT_TRUE(std::isnan(measure(none)));
  EXPECT_TRUE(std::isnan(density_ratio(1, 0)));
  EXPECT_TRUE(std::isnan(clutter_ratio(5, 0)));
  EXPECT_TRUE(std::isnan(completeness_ratio(0, 0)));
  EXPECT_TRUE(std::isnan(effectiveness_ratio(0, 0)));
}

TEST(Measures, SuccessIsEveryCornerWithinTheLimit) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 2, 0.5));
  const Pose truth = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX());
  // A turn of 0.02 rad about the box's corner z axis moves the far corner by 0.02 * |(3, 2)|.
  const Pose turned = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()) * truth;
  const double moved = 0.02 * std::hypot(3, 2);
  EXPECT_EQ(success(truth, truth, box, 0), 1);
  EXPECT_EQ(success(turned, truth, box, moved * 1.001), 1);
  EXPECT_EQ(success(turned, truth, box, moved * 0.999), 0);
  Pose nowhere = truth;
  nowhere.translation().x() = NAN;
  EXPECT_EQ(success(nowhere, truth, box, 100), 0);
}

TEST(Measures, PointToPointIsTheNearestDistanceOfEveryModelPoint) {
  std::mt19937 random{1};
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Eigen::Vector3f> model(300), scan(50);
  for (auto& p : model) p = {unit(random), unit(random), unit(random)};
  for (auto& p : scan) p = {3 + unit(random), unit(random), unit(random)};
  model[4].x() = NAN;
  scan[5].y() = INFINITY;
  double sum = 0;
  for (const auto& m : model) {
    if (!m.allFinite()) continue;
    double nearest = INFINITY;
    for (const auto& p : scan)
      if (p.allFinite()) nearest = std::min(nearest, static_cast<double>((p - m).squaredNorm()));
    sum += nearest;
  }
  const RmsDistance rms = rms_point_to_point(CloudView(model), CloudView(scan));
  EXPECT_EQ(rms.points, 299U);
  EXPECT_NEAR(rms.rms_m, std::sqrt(sum / 299), 1e-5);  // floats of a few metres
  EXPECT_EQ(rms_point_to_point({}, CloudView(scan)).points, 0U);
  EXPECT_EQ(rms_point_to_point(CloudView(model), {}).points, 0U);
}

// The same perfect scan, far apart by points, on the surface by surface.
TEST(Measures, PointToSurfaceDoesNotSeeTheSpacingThatPointToPointIsMadeOf) {
  const std::vector<test::Rod> rods = test::tee_spool();
  const DesignModel design = test::design_of(rods, 256);
  const auto surface = DesignSurface::build(design);
  ASSERT_TRUE(surface);
  std::mt19937 random{3};
  const Pose T_scan_design = test::random_motion(1, 1, random);
  const PointCloud scan = test::scan_of(rods, T_scan_design, {.points = 3000}, random);
  const PointCloud model = test::scan_of(rods, Pose::Identity(), {.points = 3000}, random);
  PointCloud scan_in_design = scan;
  for (auto& p : scan_in_design.points) p = T_scan_design.inverse().cast<float>() * p;
  const double point = rms_point_to_point(model, scan_in_design).rms_m;
  const RmsDistance flat = rms_point_to_surface(scan, *surface, T_scan_design.inverse(), 0.05);
  // 3000 points on 0.45 m2: one in 12 mm by 12 mm, the nearest some half of that away.
  EXPECT_GT(point, 0.004);
  EXPECT_LT(point, 0.015);
  // The polygon of 256 sides is inside the circle by 0.09 (1 - cos(pi / 256)) = 7 um at most.
  EXPECT_LT(flat.rms_m, 1e-5);
  EXPECT_EQ(flat.points, 3000U);
  PointCloud off = scan;
  for (std::size_t i = 0; i < off.size(); ++i) off.points[i] += 0.01F * off.normals[i];
  // 10 mm out along the normal is 10 mm off, but where another rod is nearer.
  EXPECT_NEAR(rms_point_to_surface(off, *surface, T_scan_design.inverse(), 0.05).rms_m, 0.01, 3e-4);
  EXPECT_EQ(rms_point_to_surface(off, *surface, T_scan_design.inverse(), 0.001).points < 100, true);
}

TEST(Measures, CancelledMeasuresNothing) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(rms_point_to_point(CloudView(points), CloudView(points), {stop.get_token(), {}}).points,
            0U);
}

}  // namespace
}  // namespace spool
