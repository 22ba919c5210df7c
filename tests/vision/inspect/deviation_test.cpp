// Deviations against the formulas of cylinder and plane, and the statistics of parts.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/align/synthetic_spool.h"
#include "vision/design/exterior.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::Rod;

DesignSurface surface_over(const DesignModel& design) {
  Result<DesignSurface> surface = DesignSurface::build(design);
  EXPECT_TRUE(surface);
  return std::move(*surface);
}

std::vector<PointClass> all_object(std::size_t count) {
  return std::vector<PointClass>(count, PointClass::kObject);
}

TEST(Deviation, IsTheSignedDistanceToTheCylinder) {
  const Rod rod{{0.1, 0.2, 0.3}, Vector3d(1, 2, -1).normalized(), 0.06, 0.7};
  const DesignModel design = test::design_of({rod}, 256);
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit(-1, 1);
  PointCloud scan;
  while (scan.size() < 5000) {
    const Vector3d p =
        rod.base + 0.35 * rod.direction + 0.45 * Vector3d(unit(random), unit(random), unit(random));
    if (std::abs(test::distance_to(rod, p)) < 0.03) scan.points.push_back(p.cast<float>());
  }
  auto classes = all_object(scan.size());
  const Deviations found = measure_deviations(scan, classes, surface, 0.05F);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    // 256 segments of a 60 mm radius: the sagitta is 5 um; floats add 0.1 um.
    ASSERT_NEAR(found.distance_m[i], test::distance_to(rod, scan.points[i].cast<double>()), 1e-5);
    ASSERT_EQ(found.part[i], 0);
  }
}

TEST(Deviation, StaysWhenScanAndModelMoveTogether) {
  std::mt19937 random{2};
  const auto rods = test::tee_spool();
  const PointCloud scan =
      test::scan_of(rods, Pose::Identity(), {.points = 2000, .noise_m = 0.004}, random);
  const Pose T = test::random_motion(2, 2, random);
  DesignModel moved_design = test::design_of(rods);
  for (auto& v : moved_design.mesh.vertices) v = (T * v.cast<double>()).cast<float>();
  PointCloud moved = scan;
  for (auto& p : moved.points) p = (T * p.cast<double>()).cast<float>();
  const DesignModel design = test::design_of(rods);
  auto classes = all_object(scan.size());
  const DesignModel still = exterior_of(design, surface_over(design));
  const DesignModel other = exterior_of(moved_design, surface_over(moved_design));
  const Deviations a = measure_deviations(scan, classes, surface_over(still), 0.05F);
  const Deviations b = measure_deviations(moved, classes, surface_over(other), 0.05F);
  for (std::size_t i = 0; i < scan.size(); ++i)
    EXPECT_NEAR(a.distance_m[i], b.distance_m[i], 1e-5);  // a float 2 m off is good to 0.1 um, a
                                                          // facet's normal from such to 1e-5
}

TEST(Deviation, IsTheSameToTheLastBitInAnyOrderOfThePoints) {
  const DesignModel design = test::design_of(test::tee_spool());
  const DesignSurface surface = surface_over(design);
  std::mt19937 random{5};
  const PointCloud scan =
      test::scan_of(test::tee_spool(), Pose::Identity(), {.points = 5000, .noise_m = 0.01}, random);
  auto classes = all_object(scan.size());
  const Deviations found = measure_deviations(scan, classes, surface, 0.02F);
  EXPECT_GT(std::count(classes.begin(), classes.end(), PointClass::kClutter), 0);
  for (std::size_t i = 0; i < scan.size(); ++i) {  // one by one
    const auto hit = surface.closest(scan.points[i], 0.02F);
    ASSERT_EQ(classes[i], hit ? PointClass::kObject : PointClass::kClutter);
    ASSERT_EQ(found.part[i], hit ? hit->part : -1);
    ASSERT_EQ(std::isnan(found.distance_m[i]), !hit);
    if (!hit) continue;
    ASSERT_EQ(found.distance_m[i], hit->distance);
  }
}

TEST(Deviation, ClutterAndWhatIsTooFarHaveNone) {
  const DesignModel design = test::design_of({Rod{}});
  PointCloud scan;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scan.points = {{0.06F, 0, 0.5F}, {0.06F, 0, 0.5F}, {0.09F, 0, 0.5F}, {nan, nan, nan}};
  std::vector<PointClass> classes = {PointClass::kObject, PointClass::kClutter, PointClass::kObject,
                                     PointClass::kObject};
  const Deviations found = measure_deviations(scan, classes, surface_over(design), 0.02F);
  EXPECT_NEAR(found.distance_m[0], 0.01, 1e-4);
  for (const std::size_t i : {1U, 2U, 3U}) {
    EXPECT_TRUE(std::isnan(found.distance_m[i]));
    EXPECT_EQ(found.part[i], -1);
    EXPECT_EQ(classes[i], PointClass::kClutter);
  }
}

TEST(Deviation, StatisticsAreThoseOfTheNumbers) {
  const DesignModel design = test::design_of({Rod{}});
  PointCloud scan;
  Deviations deviations;
  for (int i = 1; i <= 100; ++i) {
    scan.points.push_back({0.05F, 0, 0.5F});
    deviations.distance_m.push_back((i % 4 == 0 ? -0.001F : 0.001F) * static_cast<float>(i));
    deviations.part.push_back(0);
  }
  const auto classes = all_object(scan.size());
  const auto samples = sample_surface(design, 200);
  const PartDeviation part = summarise_parts(design, scan, classes, deviations, samples).at(0);
  EXPECT_EQ(part.points, 100U);
  // Sum of 1..100 less twice the sum of the multiples of four: 5050 - 2 * 1300.
  EXPECT_NEAR(part.mean_m, 0.001 * 24.5, 1e-7);
  EXPECT_NEAR(part.rms_m, 0.001 * std::sqrt(338350.0 / 100.0), 1e-7);  // sum of squares 338350
  EXPECT_NEAR(part.p95_abs_m, 0.095, 1e-7);
  EXPECT_NEAR(part.max_abs_m, 0.1, 1e-7);
  EXPECT_NEAR(rms(deviations, classes), part.rms_m, 1e-12);
  EXPECT_EQ(rms(Deviations{}, {}), 0.0);
}

TEST(Deviation, SteelThatContradictsSaysNothingOfTheScan) {
  Deviations deviations;
  deviations.distance_m = {0.003F, -0.004F, 0.2F};
  const std::vector classes{PointClass::kObject, PointClass::kObject, PointClass::kContradicting};
  EXPECT_NEAR(rms(deviations, classes), std::sqrt((9e-6 + 16e-6) / 2), 1e-8);
}

TEST(Coverage, IsTheShareOfTheSurfaceThatWasSeen) {
  std::mt19937 random{3};
  const auto rods = test::tee_spool();
  const DesignModel whole = test::design_of(rods);
  const DesignSurface whole_surface = surface_over(whole);
  const DesignModel design = exterior_of(whole, whole_surface);
  const DesignSurface surface = surface_over(design);
  const SurfaceSamples samples = seen_samples(sample_surface(design, 6000), whole, whole_surface);
  const auto coverage = [&](const test::ScanOptions& options, double offset) {
    const PointCloud scan =
        test::scan_of(rods, Pose(Eigen::Translation3d(0, offset, 0)), options, random);
    auto classes = all_object(scan.size());
    const Deviations deviations = measure_deviations(scan, classes, surface, 0.02F);
    return summarise_parts(design, scan, classes, deviations, samples);
  };
  const auto all_round = coverage({.points = 20000, .noise_m = 0.001}, 0);
  for (std::size_t p = 0; p < rods.size(); ++p) EXPECT_GT(all_round[p].coverage, 0.97) << p;
  // From +y the half turn less what is steeper than 78 degrees: 2 * acos(0.2) / 360 = 0.436 of a
  // pipe; one sample spacing more on either side.
  const auto half = coverage({.points = 20000, .towards = Vector3d::UnitY()}, 0);
  EXPECT_NEAR(half[0].coverage, 0.46, 0.05);
  // Where the pipe lies 6 mm off it was still seen: the foot counts, not the point.
  const auto shifted = coverage({.points = 20000, .towards = Vector3d::UnitY()}, 0.006);
  EXPECT_NEAR(shifted[0].coverage, half[0].coverage, 0.04);
  // A sparse scan of everything has seen everything too.
  const auto sparse = coverage({.points = 1500}, 0);
  EXPECT_GT(sparse[0].coverage, 0.9);
}

TEST(Coverage, APartThatNoPointLiesOnHasNone) {
  std::mt19937 random{4};
  const auto rods = test::tee_spool();
  const DesignModel design = test::design_of(rods);
  const DesignSurface surface = surface_over(design);
  const PointCloud scan = test::scan_of({rods[0]}, Pose::Identity(), {.points = 3000}, random);
  auto classes = all_object(scan.size());
  const Deviations deviations = measure_deviations(scan, classes, surface, 0.02F);
  const auto parts =
      summarise_parts(design, scan, classes, deviations, sample_surface(design, 3000));
  EXPECT_EQ(parts[4].points, 0U);
  EXPECT_EQ(parts[4].coverage, 0.0);
}

TEST(Exterior, LeavesOutTheBoreAndTheBuriedEnds) {
  // A tube: an outer rod and, turned inside out, its bore.
  DesignModel tube = test::design_of({Rod{{0, 0, 0}, Vector3d::UnitZ(), 0.05, 1.0},
                                      Rod{{0, 0, 0}, Vector3d::UnitZ(), 0.045, 1.0}});
  DesignModel open = tube;
  open.mesh.triangles.clear();
  open.triangle_part.clear();
  for (std::size_t t = 0; t < tube.mesh.triangles.size(); ++t) {
    if (t % 4 >= 2) continue;  // the discs at the ends
    Triangle triangle = tube.mesh.triangles[t];
    if (tube.triangle_part[t] == 1) std::swap(triangle[1], triangle[2]);
    open.mesh.triangles.push_back(triangle);
    open.triangle_part.push_back(0);
  }
  open.parts.resize(1);
  open.parts[0].first_triangle = 0;
  open.parts[0].triangle_count = static_cast<std::uint32_t>(open.mesh.triangles.size());
  const DesignSurface whole = surface_over(open);
  const DesignModel exterior = exterior_of(open, whole);
  EXPECT_EQ(exterior.parts[0].triangle_count, exterior.mesh.triangles.size());
  const DesignSurface surface = surface_over(exterior);
  // A reading 4 mm inside the skin of a 5 mm wall: the bore is nearer, the skin is meant.
  const Eigen::Vector3f p(0.046F, 0, 0.5F);
  EXPECT_NEAR(whole.closest(p, 0.1F)->distance, -0.001, 1e-4);
  EXPECT_NEAR(surface.closest(p, 0.1F)->distance, -0.004, 1e-4);
}

}  // namespace
}  // namespace spool
