// Principal axes: the right one of 24 combinations, and honesty where several are right.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/principal_axes.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::Rod;

// No symmetry at all: three legs in three directions, none alike.
std::vector<Rod> crooked_spool() {
  return {
      {{0, 0, 0}, Vector3d::UnitZ(), 0.05, 0.9},
      {{0, 0, 0.2}, Vector3d::UnitX(), 0.04, 0.5},
      {{0, 0, 0.75}, Vector3d::UnitY(), 0.03, 0.35},
      {{0, 0, -0.03}, Vector3d::UnitZ(), 0.09, 0.03},
  };
}

DesignSurface surface_over(const DesignModel& design) {
  Result<DesignSurface> surface = DesignSurface::build(design);
  EXPECT_TRUE(surface);
  return std::move(*surface);
}

TEST(PrincipalAxes, PlacesAWholeScanFromAnyOrientation) {
  const auto rods = crooked_spool();
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{1};
  const PointCloud samples = test::scan_of(rods, Pose::Identity(), {.points = 4000}, random);
  for (int trial = 0; trial < 8; ++trial) {
    const Pose T_true = test::random_motion(2.0, 3.0, random);
    const PointCloud scan =
        test::scan_of(rods, T_true.inverse(), {.points = 4000, .noise_m = 0.002}, random);
    const auto found = align_principal_axes(scan, samples, surface, {.noise_m = 0.002});
    EXPECT_EQ(found.combinations, 24);
    EXPECT_FALSE(found.ambiguous) << found.alternatives.size();
    // 2 mm over 4000 points: 0.1 mm and 0.4 mrad (ICP's covariance); a corner is 0.9 m off, the
    // worst of eight two deviations.
    EXPECT_LT(test::displacement_at(design.bounds(), found.best.T_design_scan, T_true), 0.0008)
        << "trial " << trial;
  }
}

TEST(PrincipalAxes, PlacesAScanOfOneSide) {
  const auto rods = crooked_spool();
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{2};
  const PointCloud samples = test::scan_of(rods, Pose::Identity(), {.points = 4000}, random);
  for (const Vector3d& side :
       {Vector3d(1, 1, 0.3), Vector3d(-1, 0.4, -0.2), Vector3d(0.1, -1, 0.5)}) {
    const Pose T_true = test::random_motion(2.0, 2.5, random);
    const PointCloud scan = test::scan_of(
        rods, T_true.inverse(), {.points = 4000, .noise_m = 0.002, .towards = side}, random);
    const auto found = align_principal_axes(scan, samples, surface, {.noise_m = 0.002});
    EXPECT_LT(test::displacement_at(design.bounds(), found.best.T_design_scan, T_true), 0.001);
  }
}

TEST(PrincipalAxes, WorksOnNormalsWithoutASignAndWithoutNormals) {
  const auto rods = crooked_spool();
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{3};
  const PointCloud samples = test::scan_of(rods, Pose::Identity(), {.points = 4000}, random);
  const Pose T_true = test::random_motion(1.0, 2.0, random);
  PointCloud scan = test::scan_of(rods, T_true.inverse(), {.points = 4000}, random);
  for (std::size_t i = 0; i < scan.size(); i += 2) scan.normals[i] = -scan.normals[i];
  const auto unsigned_normals =
      align_principal_axes(scan, samples, surface, {.oriented_normals = false});
  EXPECT_LT(test::displacement_at(design.bounds(), unsigned_normals.best.T_design_scan, T_true),
            5e-4);
  scan.normals.clear();
  const auto none = align_principal_axes(scan, samples, surface);
  EXPECT_LT(test::displacement_at(design.bounds(), none.best.T_design_scan, T_true), 5e-4);
}

TEST(PrincipalAxes, ListsThePosesOfASymmetricDesign) {
  // A bar with a like branch on each side: half a turn about any axis is the same bar.
  const std::vector<Rod> rods = {
      {{0, 0, -0.5}, Vector3d::UnitZ(), 0.05, 1.0},
      {{-0.3, 0, 0}, Vector3d::UnitX(), 0.04, 0.6},
  };
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{4};
  const PointCloud samples = test::scan_of(rods, Pose::Identity(), {.points = 4000}, random);
  const PointCloud scan =
      test::scan_of(rods, Pose::Identity(), {.points = 4000, .noise_m = 0.001}, random);
  const auto found = align_principal_axes(scan, samples, surface, {.noise_m = 0.001});
  EXPECT_TRUE(found.ambiguous);
  EXPECT_EQ(found.alternatives.size(), 3U);
}

TEST(PrincipalAxes, TurningAStraightPipeAboutItselfIsNoAlternative) {
  const std::vector<Rod> rods = {{{0, 0, 0}, Vector3d::UnitZ(), 0.05, 1.0}};
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{5};
  const PointCloud samples = test::scan_of(rods, Pose::Identity(), {.points = 3000}, random);
  const PointCloud scan =
      test::scan_of(rods, Pose::Identity(), {.points = 3000, .noise_m = 0.001}, random);
  const auto found = align_principal_axes(scan, samples, surface, {.noise_m = 0.001});
  // Of the 24 only the pipe end for end is another answer.
  EXPECT_EQ(found.alternatives.size(), 1U);
  EXPECT_EQ(found.best.weak_directions.size(), 1U);
}

TEST(PrincipalAxes, EmptyScanIsNoResult) {
  const DesignModel design = test::design_of(crooked_spool());
  std::mt19937 random{6};
  const PointCloud samples =
      test::scan_of(crooked_spool(), Pose::Identity(), {.points = 500}, random);
  const auto found = align_principal_axes({}, samples, surface_over(design));
  EXPECT_EQ(found.best.correspondences, 0U);
  EXPECT_FALSE(found.ambiguous);
}

}  // namespace
}  // namespace spool
