// Tests of chapter 5's algorithms on a synthetic scene whose truth is known point by point.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/thesis_declutter.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/inspect/k_curves.h"

namespace spool {
namespace {

struct TestScene {
  PointCloud scan, model;  // both in the design frame
  std::vector<std::uint8_t> is_object;
};

// A scanned tee in a cube full of evenly strewn clutter.
TestScene tee_in_clutter() {
  std::mt19937 random{1};
  TestScene scene;
  scene.scan = test::scan_of(test::tee_spool(), Pose::Identity(),
                             {.points = 3000, .noise_m = 0.001}, random);
  scene.scan.normals.clear();
  scene.is_object.assign(3000, 1);
  std::uniform_real_distribution<float> side(-0.4F, 1.0F);
  for (int i = 0; i < 20000; ++i)
    scene.scan.points.emplace_back(side(random), side(random), side(random));
  scene.is_object.resize(scene.scan.size(), 0);
  scene.model = test::scan_of(test::tee_spool(), Pose::Identity(), {.points = 2000}, random);
  return scene;
}

TEST(ThesisDeclutter, TriesTheThesissKs) {
  EXPECT_EQ(thesis_ks(81272, 12061), (std::vector<int>{1, 7, 10, 50, 110, 285}));  // Table 5-1
  EXPECT_EQ(thesis_ks(1, 100), (std::vector<int>{1, 10, 50}));
  EXPECT_EQ(thesis_ks(0, 0), (std::vector<int>{1, 10, 50}));
}

TEST(ThesisDeclutter, NoiseRisesAndVoidFallsWithKAndTheCountsAddUp) {
  const TestScene scene = tee_in_clutter();
  const std::vector<int> ks = thesis_ks(scene.scan.size(), scene.model.size());
  const auto rates = rates_by_k(scene.scan, scene.model, scene.is_object, ks);
  ASSERT_EQ(rates.size(), ks.size());
  std::vector<double> k, noise, lost;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const KeptCounts& counts = rates[i].counts;
    EXPECT_EQ(rates[i].k, ks[i]);
    EXPECT_EQ(counts.object, 3000U);
    const DeclutterResult kept = declutter_knn(scene.scan, scene.model, {.k = ks[i]});
    EXPECT_EQ(counts.kept, kept.object);
    if (i > 0) {
      // The neighbours of a smaller K are among those of a larger: what A4 holds the thesis to.
      EXPECT_GE(counts.true_kept, rates[i - 1].counts.true_kept);
      EXPECT_GT(counts.kept, rates[i - 1].counts.kept);
    }
    k.push_back(ks[i]);
    noise.push_back(noise_rate(counts));
    lost.push_back(void_rate(counts));
  }
  const LogCurve noise_curve = fit_log_curve(k, noise);
  const PowerCurve void_curve = fit_power_curve(k, lost);
  EXPECT_GT(noise_curve.a, 0);
  EXPECT_LT(void_curve.b, 0);
  EXPECT_GE(k_by_crossing(noise_curve, void_curve), 1);
}

TEST(ThesisDeclutter, AlgorithmOneRefinesThePoseAndKeepsTheObject) {
  TestScene scene = tee_in_clutter();
  std::mt19937 random{3};
  const Pose T_design_scan = test::random_motion(1, 1, random);
  for (auto& p : scene.scan.points) p = T_design_scan.inverse().cast<float>() * p;
  const Pose guess = test::random_motion(0.01, 0.01, random) * T_design_scan;
  const auto isolation =
      isolate_by_neighbours(scene.scan, scene.model, guess, {.declutter = {.k = 3}});
  const Eigen::AlignedBox3d box = test::design_of(test::tee_spool()).bounds();
  // ICP, drawn aside by the clutter inside and outside alike, ends nearer than it began.
  EXPECT_LT(test::displacement_at(box, isolation.T_design_scan, T_design_scan),
            0.6 * test::displacement_at(box, guess, T_design_scan));
  EXPECT_EQ(isolation.kept.k, 3);
  EXPECT_EQ(isolation.kept.classes.size(), scene.scan.size());
  EXPECT_DOUBLE_EQ(isolation.unique_share,
                   static_cast<double>(isolation.kept.object) / (3.0 * 2000.0));
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3000; ++i)
    found += isolation.kept.classes[i] == PointClass::kObject ? 1U : 0U;
  EXPECT_GT(found, 1500U);
  const auto as_given = isolate_by_neighbours(scene.scan, scene.model, guess,
                                              {.declutter = {.k = 3}, .icp_iterations = 0});
  EXPECT_LT(test::displacement_at(box, as_given.T_design_scan, guess), 1e-12);
}

TEST(ThesisDeclutter, CancelledKeepsNothingAndEmptyCloudsGiveEmptyAnswers) {
  const TestScene scene = tee_in_clutter();
  std::stop_source stop;
  stop.request_stop();
  const Watch watch{stop.get_token(), {}};
  const std::vector<int> ks = {1, 2};
  EXPECT_TRUE(rates_by_k(scene.scan, scene.model, scene.is_object, ks, watch).empty());
  EXPECT_EQ(isolate_by_neighbours(scene.scan, scene.model, Pose::Identity(), {}, watch).kept.object,
            0U);
  EXPECT_TRUE(isolate_by_neighbours({}, {}, Pose::Identity()).kept.classes.empty());
}

}  // namespace
}  // namespace spool
