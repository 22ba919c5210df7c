// The quick refinement: from as far as a pair's pose is off to the noise, amid clutter.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/find/field_icp.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/vision/find/room.h"
#include "vision/design/sampling.h"

namespace spool {
namespace {

struct Prepared {
  double size_m = 0;
  PointCloud samples;
  SurfaceField field;
};

Prepared prepared(const std::vector<test::Rod>& rods) {
  const DesignModel design = test::design_of(rods);
  Prepared model;
  model.size_m = design.bounds().diagonal().norm();
  model.samples = sample_surface(design, 4000).cloud;
  model.field = SurfaceField(model.samples, model.size_m / 200, 0.03 * model.size_m);
  return model;
}

double worst_shift(const PointCloud& samples, const Pose& T_a, const Pose& T_b) {
  double worst = 0;
  for (const Eigen::Vector3f& sample : samples.points) {
    const Eigen::Vector3d p = sample.cast<double>();
    worst = std::max(worst, (T_a * T_b.inverse() * p - p).norm());
  }
  return worst;
}

TEST(FieldIcp, EndsAtTheNoiseFromWhereAPairsPoseIsOff) {
  const auto rods = test::tee_spool();
  const Prepared model = prepared(rods);
  const double rough = 0.015 * model.size_m;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random{seed};
    const Pose T_true = test::random_motion(2, 2, random);
    std::vector<Eigen::Vector3f> scan =
        test::scan_of(rods, T_true.inverse(),
                      {.points = 4000, .noise_m = 0.002, .towards = {0.3, 1, 0.4}}, random)
            .points;
    // The table under it, seen through, and a loose cloud of clutter round it.
    std::vector<Eigen::Vector3f> table;
    test::add_rectangle(table, {-0.5, -0.09, -0.5}, {0, 0, 1.8}, {1.2, 0, 0}, 4000, 0.002, random);
    for (const Eigen::Vector3f& p : table) scan.push_back(T_true.inverse().cast<float>() * p);
    const Pose guess = test::random_motion(rough, rough / (0.5 * model.size_m), random) * T_true;
    const FieldIcpResult found =
        refine_on_field(scan, model.samples, model.field, guess.cast<float>(),
                        {.iterations = 15, .start_gate_m = 1.3 * rough, .end_gate_m = 0.006});
    // 2 mm over 2500 points; the samples' tangent planes stand off a 40 mm pipe by half a
    // millimetre at a cell's distance (5 mm), and the table's strip inside the gate pulls.
    EXPECT_LT(worst_shift(model.samples, found.T_design_scan.cast<double>(), T_true), 0.003)
        << "seed " << seed;
    EXPECT_GT(found.inliers, 500U);
    EXPECT_LT(found.rms_m, 0.003);
    EXPECT_NEAR(found.T_design_scan.linear().determinant(), 1, 1e-4);
  }
}

TEST(FieldIcp, LeavesThePoseWhereThereIsNothingToGoBy) {
  const Prepared model = prepared(test::tee_spool());
  std::mt19937 random{1};
  const Eigen::Isometry3f guess = test::random_motion(1, 1, random).cast<float>();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> none,
      one(1, guess.inverse() * Eigen::Vector3f(0.05F, 0, 0.2F)),
      away(100, Eigen::Vector3f(1e6F, 1e6F, 1e6F)), unmeasured(100, Eigen::Vector3f(nan, nan, nan));
  for (const auto& scan : {none, one, away, unmeasured}) {
    const FieldIcpResult found = refine_on_field(scan, model.samples, model.field, guess, {});
    EXPECT_TRUE(found.T_design_scan.isApprox(guess, 1e-5F));
    EXPECT_LT(found.inliers, 6U);
  }
  // All in one place: five motions are not held.
  const std::vector<Eigen::Vector3f> heap(50, one[0]);
  const FieldIcpResult found = refine_on_field(heap, model.samples, model.field, guess, {});
  EXPECT_TRUE(found.T_design_scan.matrix().allFinite());
}

TEST(FieldIcp, DoesNotWanderAlongAStraightPipe) {
  const std::vector<test::Rod> pipe = {{{0, 0, 0}, Eigen::Vector3d::UnitZ(), 0.03, 2.0}};
  const Prepared model = prepared(pipe);
  std::mt19937 random{3};
  const std::vector<Eigen::Vector3f> scan =
      test::scan_of({{{0, 0, 0.5}, Eigen::Vector3d::UnitZ(), 0.03, 1.0}}, Pose::Identity(),
                    {.points = 2000, .noise_m = 0.001, .with_ends = false}, random)
          .points;
  Pose guess = Pose::Identity();
  guess.translation() = Eigen::Vector3d(0.01, -0.01, 0.02);
  const FieldIcpResult found =
      refine_on_field(scan, model.samples, model.field, guess.cast<float>(),
                      {.iterations = 15, .start_gate_m = 0.03, .end_gate_m = 0.006});
  EXPECT_LT(found.T_design_scan.translation().head<2>().norm(), 0.001F);  // set right across
  // Facets of 2 mm hold a little along and about it; the ridge holds more.
  EXPECT_NEAR(found.T_design_scan.translation().z(), 0.02F, 0.003F);
}

}  // namespace
}  // namespace spool
