// The laws of Poisson-disk samples: distance, cover, count, repeatability, evenness.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/sampling.h"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/design/shapes.h"
#include "vision/design/design_surface.h"
#include "vision/scan/point_index.h"

namespace spool::test {
namespace {

// A box with one long, slender and one large face pair beside a finely cut torus: triangles far
// larger and far smaller than the radius.
DesignModel mixed_design() {
  DesignModel design = box_design({0, 0, 0}, {0.5, 0.2, 0.01});
  append_design(design, torus_design(0.2, 0.05, 200, 80));
  return design;
}

TEST(Sampling, KeepsItsCountDistanceAndCover) {
  const DesignModel design = mixed_design();
  const Result<DesignSurface> surface = DesignSurface::build(design);
  ASSERT_TRUE(surface);
  for (const std::size_t count : {500U, 4000U}) {
    const SurfaceSamples samples = sample_surface(design, count);
    EXPECT_NEAR(static_cast<double>(samples.cloud.size()), static_cast<double>(count),
                0.15 * static_cast<double>(count));
    ASSERT_EQ(samples.part.size(), samples.cloud.size());
    ASSERT_TRUE(samples.cloud.has_normals());
    const PointIndex index(samples.cloud.points);
    std::vector<Neighbour> two;
    for (std::size_t i = 0; i < samples.cloud.size(); ++i) {
      index.nearest_k(samples.cloud.points[i], 2, 10, two);
      ASSERT_EQ(two.size(), 2U);
      EXPECT_GE(two[1].distance, samples.radius_m * (1 - 1e-5));
      const auto on = surface->closest(samples.cloud.points[i], 1);
      ASSERT_TRUE(on);
      EXPECT_NEAR(on->distance, 0, 1e-6);
    }
    // Every corner and random places of every triangle see a sample within two radii.
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto covered = [&](const Eigen::Vector3d& p) {
      return index.nearest(p.cast<float>(), static_cast<float>(2 * samples.radius_m)).has_value();
    };
    for (std::size_t t = 0; t < design.mesh.triangles.size(); ++t) {
      const Eigen::Vector3d a = corner(design, t, 0);
      const Eigen::Vector3d b = corner(design, t, 1);
      const Eigen::Vector3d c = corner(design, t, 2);
      EXPECT_TRUE(covered(a) && covered(b) && covered(c));
      for (int i = 0; i < (t < 12 ? 500 : 1); ++i) {
        const double u = uniform(random);
        const double v = uniform(random) * (1 - u);
        EXPECT_TRUE(covered(a + u * (b - a) + v * (c - a)));
      }
    }
  }
}

TEST(Sampling, GivesTheSameForTheSameSeedAndOthersForAnother) {
  const DesignModel design = mixed_design();
  const SurfaceSamples a = sample_surface(design, 1000, 7);
  const SurfaceSamples b = sample_surface(design, 1000, 7);
  const SurfaceSamples c = sample_surface(design, 1000, 8);
  EXPECT_EQ(a.cloud.points, b.cloud.points);
  EXPECT_EQ(a.part, b.part);
  EXPECT_NE(a.cloud.points, c.cloud.points);
}

TEST(Sampling, SharesSamplesByArea) {
  DesignModel design = box_design({0, 0, 0}, {0.2, 0.2, 0.2});
  append_design(design, box_design({2, 0, 0}, {0.4, 0.4, 0.4}));  // four times the area
  const SurfaceSamples samples = sample_surface(design, 4000);
  double second = 0;
  for (const std::int32_t part : samples.part) second += part;
  // Saturated disks are far more even than independent throws, whose deviation would be 0.6 %;
  // edges, where disks hang over, favour the small box slightly.
  EXPECT_NEAR(second / static_cast<double>(samples.part.size()), 0.8, 0.02);
}

TEST(Sampling, HasOutwardNormalsOfItsFaces) {
  const DesignModel design = torus_design(0.3, 0.1, 100, 50);
  const SurfaceSamples samples = sample_surface(design, 800);
  for (std::size_t i = 0; i < samples.cloud.size(); ++i) {
    const Eigen::Vector3d p = samples.cloud.points[i].cast<double>();
    const Eigen::Vector3d ring = 0.3 * Eigen::Vector3d(p.x(), p.y(), 0).normalized();
    // A facet of a fiftieth of a turn leans by up to half of that: 3.6 degrees, cos 0.998.
    EXPECT_GT(samples.cloud.normals[i].cast<double>().dot((p - ring).normalized()), 0.997);
  }
}

TEST(Sampling, ThinsACloudToItsOwnPoints) {
  DesignModel design;
  Part part;
  part.name = "cloud";
  design.parts.push_back(part);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const float x = uniform(random);
    design.cloud.points.emplace_back(x, uniform(random), 0.0F);
    design.cloud.normals.push_back(Eigen::Vector3f::UnitZ());
  }
  design.cloud.points[5].x() = std::nanf("");
  const SurfaceSamples samples = sample_surface(design, 1000);
  EXPECT_NEAR(static_cast<double>(samples.cloud.size()), 1000, 150);
  const PointIndex all(design.cloud.points);
  const PointIndex kept(samples.cloud.points);
  std::vector<Neighbour> two;
  for (const Eigen::Vector3f& point : samples.cloud.points) {
    EXPECT_TRUE(all.nearest(point, 1e-9F));
    kept.nearest_k(point, 2, 10, two);
    EXPECT_GE(two[1].distance, samples.radius_m * (1 - 1e-5));
  }
  for (const Eigen::Vector3f& point : design.cloud.points) {
    if (!point.allFinite()) continue;
    EXPECT_TRUE(kept.nearest(point, static_cast<float>(2 * samples.radius_m)));
  }
  EXPECT_EQ(sample_surface(design, 50000).cloud.size(), 19999U);  // asked for more than there are
}

TEST(Sampling, OfNothingIsNothing) {
  EXPECT_TRUE(sample_surface(DesignModel{}, 100).cloud.empty());
  EXPECT_TRUE(sample_surface(mixed_design(), 0).cloud.empty());
}

TEST(Sampling, CancelledEndsEarly) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(sample_surface(mixed_design(), 5000, 1, {stop.get_token(), {}}).cloud.empty());
}

}  // namespace
}  // namespace spool::test
