// The main path with no hint on third-party clouds and on simulated scenes, with and without what
// is looked for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "tests/vision/find/room.h"
#include "tests/vision/scene.h"
#include "vision/design/design_reader.h"
#include "vision/inspector.h"
#include "vision/scan/cloud_file.h"
#include "vision/scan/noise_estimate.h"
#include "vision/scan/point_index.h"

namespace spool {
namespace {

using test::Scene;

constexpr double kDegree = std::numbers::pi / 180;

Alignment find_in(const std::shared_ptr<const PreparedDesign>& design, const PointCloud& scan) {
  const NoiseModel noise{.constant_m = estimate_noise(scan)};
  const auto inspection = Inspector(design).process(scan, noise, {.align = AlignMethod::kFind});
  EXPECT_TRUE(inspection);
  return inspection ? inspection->alignment : Alignment{};
}

// The scan less the points for which `is_object` holds.
template <class IsObject>
PointCloud without(const PointCloud& scan, const IsObject& is_object) {
  PointCloud rest;
  rest.origin = scan.origin;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (!is_object(i)) rest.points.push_back(scan.points[i]);
  return rest;
}

struct FindCase {
  const char* folder;
  double worst_m, angle_deg;
};

class ScenesWithNoHint : public testing::TestWithParam<FindCase> {};

TEST_P(ScenesWithNoHint, AreFoundAndNotFoundOnceTheObjectIsTakenAway) {
  SPOOL_REQUIRE_SHARED(folder, std::string("scenes/") + GetParam().folder);
  const Scene scene = test::load_scene(folder, true);
  const Alignment found = find_in(scene.design, scene.cloud);
  ASSERT_TRUE(found.found) << found.reason;
  EXPECT_FALSE(found.ambiguous && !found.is_symmetric);
  EXPECT_TRUE(found.weak_directions.empty());
  // Of poses that a symmetry of the design makes equal, any one is right.
  test::PoseError error =
      test::pose_error(scene.design->samples, found.T_design_scan, scene.T_design_scan);
  for (const Pose& motion : scene.design->finder->symmetries) {
    const auto other =
        test::pose_error(scene.design->samples, found.T_design_scan, motion * scene.T_design_scan);
    if (other.worst_m < error.worst_m) error = other;
  }
  RecordProperty("worst_mm", std::to_string(1000 * error.worst_m));
  RecordProperty("angle_deg", std::to_string(error.angle_rad / kDegree));
  EXPECT_LT(error.worst_m, GetParam().worst_m);
  EXPECT_LT(error.angle_rad, GetParam().angle_deg * kDegree);
  const Alignment gone = find_in(
      scene.design, without(scene.cloud, [&](std::size_t i) { return scene.labels[i] < 1000; }));
  EXPECT_FALSE(gone.found);
  EXPECT_NE(gone.reason.find("not found"), std::string::npos) << gone.reason;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ScenesWithNoHint,
    testing::Values(
        // 2 mm over thousands of points, and stations 0.6 mm off each other.
        FindCase{"ps_laser", 0.003, 0.3}, FindCase{"bf_laser", 0.003, 0.3},
        // The part that is as designed holds the pose; the arm turned away does not.
        FindCase{"spool2_laser_defect", 0.003, 0.3},
        // As built a pipe is 6 mm long and all behind it is 4 degrees off: a pose fitted to the
        // whole lies between.
        FindCase{"spool1_handheld", 0.010, 1.2}),
    [](const auto& row) { return std::string(row.param.folder); });

TEST(MilkCarton, IsFoundWithNoHintAndNotWhereItWasCutOut) {
  SPOOL_REQUIRE_SHARED(folder, "clouds/pcl_milk");
  auto model = read_design(folder / "milk.pcd", LengthUnit::kMetre);
  const auto scene = read_cloud(folder / "milk_cartoon_all_small_clorox.pcd", LengthUnit::kMetre);
  ASSERT_TRUE(model && scene);
  const auto design = PreparedDesign::prepare(std::move(*model), 1, true);
  ASSERT_TRUE(design);
  Pose T_scan_design = Pose::Identity();                           // the data's README
  T_scan_design.matrix() << 0.96888, -0.11971, 0.21666, -0.15897,  //
      0.11683, 0.99281, 0.02612, 0.21250,                          //
      -0.21823, 0.00000, 0.97590, -0.04213,                        //
      0, 0, 0, 1;
  T_scan_design.linear() =
      Eigen::Quaterniond(T_scan_design.linear()).normalized().toRotationMatrix();
  const Pose T_true = T_scan_design.inverse();
  const Alignment found = find_in(*design, scene->cloud);
  ASSERT_TRUE(found.found) << found.reason;
  const auto error = test::pose_error((*design)->samples, found.T_design_scan, T_true);
  RecordProperty("worst_mm", std::to_string(1000 * error.worst_m));
  EXPECT_LT(error.worst_m, 0.001);  // the model is a copy of the scene's own points
  EXPECT_LT(error.angle_rad, 0.2 * kDegree);
  // The README's five digits are good to 0.02 mm; what is left of the carton is its edge.
  const PointIndex carton((*design)->model.cloud.points);
  const PointCloud rest = without(scene->cloud, [&](std::size_t i) {
    const Eigen::Vector3f p = (T_true * scene->cloud.points[i].cast<double>()).cast<float>();
    return p.allFinite() && carton.nearest(p, 0.002F).has_value();
  });
  const Alignment gone = find_in(*design, rest);
  EXPECT_FALSE(gone.found);
  EXPECT_NE(gone.reason.find("not found"), std::string::npos) << gone.reason;
}

TEST(ScanOfMillions, IsThinnedToBeSearchedAndSaysSoButAllOfItIsMeasured) {
  const auto design = PreparedDesign::prepare(test::design_of(test::tee_spool()), 1, true);
  ASSERT_TRUE(design);
  std::mt19937 random{5};
  const test::Room room = test::make_room(test::tee_spool(), {.noise_m = 0.001}, random);
  std::normal_distribution<float> jitter(0.0F, 0.001F);
  PointCloud scan;
  while (scan.size() < 1'600'000)
    for (const Eigen::Vector3f& p : room.points)
      scan.points.emplace_back(p + Eigen::Vector3f(jitter(random), jitter(random), jitter(random)));
  const auto inspection = Inspector(*design).process(scan, {.constant_m = 0.0015},
                                                     {.align = AlignMethod::kFind, .seed = 1});
  ASSERT_TRUE(inspection);
  const Alignment& found = inspection->alignment;
  ASSERT_TRUE(found.found) << found.reason;
  EXPECT_NE(found.reason.find(std::to_string(scan.size()) + " points"), std::string::npos)
      << found.reason;
  EXPECT_LT(
      test::pose_error((*design)->samples, found.T_design_scan, room.T_scan_design[0].inverse())
          .worst_m,
      0.002);
  EXPECT_EQ(inspection->declutter.classes.size(), scan.size());
  EXPECT_GT(inspection->declutter.object, 20'000U);
}

}  // namespace
}  // namespace spool
