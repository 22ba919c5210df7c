// Tests of hi-lo at butt welds: as drawn, stepped, another diameter, and what is not measured.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/measure/fit_up.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "tests/vision/measure/two_flange_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.05715;

// Two pipes of 0.4 m in line, butt-welded at z = 0.4.
DesignModel two_pipes() {
  DesignModel design = test::design_of({{{0, 0, 0}, Vector3d::UnitZ(), kRadius, 0.4},
                                        {{0, 0, 0.4}, Vector3d::UnitZ(), kRadius, 0.4}},
                                       192);
  for (std::size_t p = 0; p < 2; ++p) {
    Part& part = design.parts[p];
    part.T_design_part = Pose::Identity();
    part.name = p == 0 ? "pipe_1" : "pipe_2";
    part.kind = PartKind::kPipe;
    part.nps = 4;
    const double z = p == 0 ? 0 : 0.4;
    part.ports = {{"in", {0, 0, z}, -Vector3d::UnitZ(), 4, EndType::kButtWeld},
                  {"out", {0, 0, z + 0.4}, Vector3d::UnitZ(), 4, EndType::kButtWeld}};
  }
  design.joints = {{"W1", 0, 1, 1, 0}};
  return design;
}

FitUp measured(const Vector3d& step, double radius, std::uint32_t seed) {
  const DesignModel design = two_pipes();
  std::mt19937 random{seed};
  PointCloud scan = test::scan_of({{{0, 0, 0}, Vector3d::UnitZ(), kRadius, 0.4}}, Pose::Identity(),
                                  {.points = 6000, .noise_m = 0.0005, .with_ends = false}, random);
  const PointCloud second = test::scan_of(
      {{{0, 0, 0.4}, Vector3d::UnitZ(), radius, 0.4}}, Pose(Eigen::Translation3d(step)),
      {.points = 6000, .noise_m = 0.0005, .with_ends = false}, random);
  scan.normals.clear();
  scan.points.insert(scan.points.end(), second.points.begin(), second.points.end());
  const std::vector<FitUp> all = fit_ups(design, test::features_of(design, scan));
  EXPECT_EQ(all.size(), 1U);
  return all.at(0);
}

TEST(FitUps, OfPipesInLineAreNothing) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const FitUp fit_up = measured(Vector3d::Zero(), kRadius, seed);
    EXPECT_TRUE(fit_up.is_measured) << fit_up.reason;
    EXPECT_LT(fit_up.hi_lo_m, 3 * fit_up.u_m + 1e-5);
    EXPECT_LT(fit_up.hi_lo_m, 0.0003);
    EXPECT_FALSE(fit_up.root_gap.empty());
  }
}

TEST(FitUps, FindAStepOfTwoMillimetresWithinItsUncertainty) {
  int inside = 0;
  constexpr int kDraws = 40;
  for (std::uint32_t seed = 1; seed <= kDraws; ++seed) {
    const FitUp fit_up = measured({0.0016, 0.0012, 0}, kRadius, seed);
    ASSERT_TRUE(fit_up.is_measured) << fit_up.reason;
    EXPECT_NEAR(fit_up.hi_lo_m, 0.002, 0.0003);
    inside += std::abs(fit_up.hi_lo_m - 0.002) < 2 * fit_up.u_m;
  }
  EXPECT_GE(inside, 0.9 * kDraws);
}

TEST(FitUps, CountHalfTheDifferenceOfDiameters) {
  const FitUp fit_up = measured(Vector3d::Zero(), kRadius + 0.001, 1);
  EXPECT_NEAR(fit_up.radius_step_m, 0.001, 3 * fit_up.u_m);
  EXPECT_NEAR(fit_up.hi_lo_m, 0.001, 3 * fit_up.u_m);
  EXPECT_LT(fit_up.offset_m, 0.0003);
}

TEST(FitUps, AreNotMeasuredAtFittingsAndWhereAPipeWasNotSeen) {
  const DesignModel design = test::two_flange_spool();
  const std::vector<FitUp> all = fit_ups(design, test::features_of(design, test::SpoolScan{}));
  ASSERT_EQ(all.size(), 4U);
  for (const FitUp& fit_up : all) {
    EXPECT_FALSE(fit_up.is_measured) << fit_up.weld;
    EXPECT_NE(fit_up.reason.find("has no cylinder"), std::string::npos) << fit_up.reason;
  }
  EXPECT_NE(all[1].reason.find("elbow_1"), std::string::npos);
  const std::vector<FitUp> unseen =
      fit_ups(two_pipes(), PartFeatures{.why_not = {"nothing of it was seen", ""}});
  EXPECT_NE(unseen.at(0).reason.find("nothing of it was seen"), std::string::npos);
  DesignModel bolted = two_pipes();
  for (Part& part : bolted.parts)
    for (Port& port : part.ports) port.end = EndType::kFlanged;
  EXPECT_TRUE(fit_ups(bolted, PartFeatures{.why_not = {"", ""}}).empty());
}

}  // namespace
}  // namespace spool
