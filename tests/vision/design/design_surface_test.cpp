// Closest points, signs and ray hits against formulas and brute force.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/design_surface.h"

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/vision/design/shapes.h"

namespace spool::test {
namespace {

// Float coordinates of a metre carry 1.2e-7 m; a distance adds a few of them.
constexpr double kFloat = 2e-6;  // m

Eigen::Vector3f random_in(std::mt19937& random, float reach) {
  std::uniform_real_distribution<float> uniform(-reach, reach);
  const float x = uniform(random);
  const float y = uniform(random);
  return {x, y, uniform(random)};
}

DesignSurface built(const DesignModel& design) {
  Result<DesignSurface> surface = DesignSurface::build(design);
  EXPECT_TRUE(surface.has_value());
  return std::move(*surface);
}

// Inside by the number of times a ray leaves; away from edges by a slanted direction.
bool is_inside(const DesignModel& design, const Eigen::Vector3d& p) {
  int crossings = 0;
  const Eigen::Vector3d direction = Eigen::Vector3d(0.6123, -0.3371, 0.7151).normalized();
  for (std::size_t t = 0; t < design.mesh.triangles.size(); ++t) {
    if (ray_distance(p, direction, corner(design, t, 0), corner(design, t, 1),
                     corner(design, t, 2)) > 0) {
      ++crossings;
    }
  }
  return crossings % 2 == 1;
}

TEST(DesignSurface, AgreesWithTheBoxFormulaAtFacesEdgesAndCorners) {
  const Eigen::Vector3d centre(0.1, -0.2, 0.3);
  const Eigen::Vector3d half(0.3, 0.2, 0.1);
  const DesignModel design = box_design(centre, half);
  const DesignSurface surface = built(design);
  std::mt19937 random(1);
  int near_edges = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f query = random_in(random, 0.8F);
    const auto found = surface.closest(query, 10);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, box_distance(query.cast<double>(), centre, half), kFloat);
    // The point lies on the surface, at that distance.
    EXPECT_NEAR(box_distance(found->point.cast<double>(), centre, half), 0, kFloat);
    EXPECT_NEAR((query - found->point).norm(), std::abs(found->distance), kFloat);
    EXPECT_NEAR(found->normal.norm(), 1, 1e-5);
    const Eigen::Vector3d q = (query.cast<double>() - centre).cwiseAbs() - half;
    if ((q.array() > 0).count() >= 2) ++near_edges;
  }
  EXPECT_GT(near_edges, 500);  // the test did reach edges and corners
}

TEST(DesignSurface, HasTheSignOfInsideAndOutsideRoundASharpTip) {
  const DesignModel design = needle_design();
  const DesignSurface surface = built(design);
  std::mt19937 random(2);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    Eigen::Vector3f query = 0.08F * random_in(random, 1);
    query.z() = 0.5F + 7 * query.z();
    const auto found = surface.closest(query, 10);
    ASSERT_TRUE(found);
    if (std::abs(found->distance) < kFloat) continue;
    const bool is_in = is_inside(design, query.cast<double>());
    inside += is_in ? 1 : 0;
    EXPECT_EQ(found->distance < 0, is_in) << query.transpose();
  }
  EXPECT_GT(inside, 100);
}

TEST(DesignSurface, AgreesWithTheTorusFormulaWithinItsFacets) {
  const double R = 0.5;
  const double r = 0.1;
  const int around = 128;
  const int across = 64;
  const DesignModel design = torus_design(R, r, around, across);
  const DesignSurface surface = built(design);
  // Facets leave the round by the sagitta of their chords, radius (1 - cos(pi / n)): inwards where
  // it is a dome, outwards along the ring's inner side.
  const double sagitta = (R + r) * (1 - std::cos(std::numbers::pi / around)) +
                         r * (1 - std::cos(std::numbers::pi / across));
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f query = random_in(random, 0.7F);
    const auto found = surface.closest(query, 10);
    ASSERT_TRUE(found);
    const double truth = torus_distance(query.cast<double>(), R, r);
    EXPECT_NEAR(found->distance, truth, sagitta + kFloat);
  }
}

TEST(DesignSurface, FindsTheDistanceThatBruteForceFinds) {
  DesignModel design = capped_cylinder_design(0.05, 0.4, 24);
  append_design(design, torus_design(0.2, 0.04, 20, 12));
  append_design(design, box_design({0.3, 0.1, 0.2}, {0.1, 0.05, 0.02}));
  const DesignSurface surface = built(design);
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f query = random_in(random, 0.5F);
    double best = 1e9;
    std::int32_t part = -1;
    double other_part = 1e9;  // nearest of any other part, to leave ties out
    for (std::size_t t = 0; t < design.mesh.triangles.size(); ++t) {
      const double d = triangle_distance(query.cast<double>(), corner(design, t, 0),
                                         corner(design, t, 1), corner(design, t, 2));
      if (d < best) {
        if (design.triangle_part[t] != part) other_part = best;
        best = d;
        part = design.triangle_part[t];
      } else if (design.triangle_part[t] != part) {
        other_part = std::min(other_part, d);
      }
    }
    const auto found = surface.closest(query, 10);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::abs(found->distance), best, kFloat);
    if (other_part > best + kFloat) {
      EXPECT_EQ(found->part, part);
    }
    EXPECT_EQ(found->part, design.triangle_part[found->element]);
  }
}

TEST(DesignSurface, KeepsThePartsOfATouchingPairApart) {
  // Two boxes share a face. Outside, over the seam, both say outside; were they welded into one,
  // the buried faces would turn the normals there.
  DesignModel design = box_design({-0.1, 0, 0}, {0.1, 0.1, 0.1});
  append_design(design, box_design({0.1, 0, 0}, {0.1, 0.1, 0.1}));
  const DesignSurface surface = built(design);
  for (float x = -0.15F; x < 0.15F; x += 0.005F) {
    const auto found = surface.closest({x, 0.103F, 0.02F}, 1);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, 0.003, kFloat) << x;
    EXPECT_NEAR(found->normal.y(), 1, 0.3);
    if (std::abs(x) > 1e-3F) {
      EXPECT_EQ(found->part, x < 0 ? 0 : 1) << x;
    }
  }
}

TEST(DesignSurface, FindsNothingBeyondTheBound) {
  const DesignModel design = box_design({0, 0, 0}, {0.1, 0.1, 0.1});
  const DesignSurface surface = built(design);
  EXPECT_FALSE(surface.closest({0.2F, 0, 0}, 0.0999F));
  EXPECT_TRUE(surface.closest({0.2F, 0, 0}, 0.1001F));
  EXPECT_FALSE(surface.closest({std::nanf(""), 0, 0}, 1));
}

TEST(DesignSurface, CountsAPointOnTheSurfaceAsZero) {
  const DesignModel design = box_design({0, 0, 0}, {0.1, 0.1, 0.1});
  const DesignSurface surface = built(design);
  const auto found = surface.closest({0.1F, 0.02F, 0.03F}, 1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance, 0, 1e-7);
}

TEST(DesignSurface, CastsRaysAsBruteForceDoes) {
  DesignModel design = torus_design(0.2, 0.05, 20, 12);
  append_design(design, needle_design());
  const DesignSurface surface = built(design);
  std::mt19937 random(5);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3f from = random_in(random, 0.6F);
    const Eigen::Vector3f direction = (0.5F * random_in(random, 0.5F) - from).normalized();
    double best = 1e9;
    for (std::size_t t = 0; t < design.mesh.triangles.size(); ++t) {
      const double d =
          ray_distance(from.cast<double>(), direction.cast<double>(), corner(design, t, 0),
                       corner(design, t, 1), corner(design, t, 2));
      if (d > 0) best = std::min(best, d);
    }
    const auto hit = surface.cast(from, direction, 5);
    ASSERT_EQ(hit.has_value(), best < 5) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->distance, best, 1e-5);  // grazing rays lengthen the float error
    EXPECT_NEAR(hit->normal.norm(), 1, 1e-5);
    EXPECT_FALSE(surface.cast(from, direction, static_cast<float>(best) * 0.999F));
  }
  EXPECT_GT(hits, 500);
}

TEST(DesignSurface, MovesWithTheDesign) {
  // Sixteen metres out, as far as a design may lie unrebased: float steps are two micrometres
  // there.
  const Eigen::Vector3d far(16, -16, 16);
  const DesignSurface near_surface = built(box_design({0, 0, 0}, {0.1, 0.2, 0.3}));
  const DesignModel moved = box_design(far, {0.1, 0.2, 0.3});
  const DesignSurface far_surface = built(moved);
  std::mt19937 random(6);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3f query = random_in(random, 0.5F);
    const auto a = near_surface.closest(query, 10);
    const auto b = far_surface.closest(query + far.cast<float>(), 10);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(a->distance, b->distance, 1e-5);
  }
}

TEST(DesignSurface, RefusesADesignWithoutArea) {
  DesignModel design = box_design({0, 0, 0}, {0.1, 0.1, 0.1});
  for (Eigen::Vector3f& vertex : design.mesh.vertices) vertex.setZero();
  const Result<DesignSurface> surface = DesignSurface::build(design);
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().code, ErrorCode::kBadInput);
  EXPECT_NE(surface.error().message.find("no triangle with an area"), std::string::npos);
  EXPECT_FALSE(DesignSurface::build(DesignModel{}));
  EXPECT_FALSE(DesignSurface::build(CloudView{}));
}

// A pipe's cloud: points every 4 mm or so on a cylinder about z.
PointCloud cylinder_cloud(double radius, double length, double spacing, bool with_normals) {
  PointCloud cloud;
  const int around = static_cast<int>(std::lround(2 * std::numbers::pi * radius / spacing));
  int row = 0;
  for (double z = 0; z <= length; z += spacing, ++row) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * (row % 2)) / around;
      const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
      cloud.points.push_back((radius * out + Eigen::Vector3d(0, 0, z)).cast<float>());
      if (with_normals) cloud.normals.push_back(out.cast<float>());
    }
  }
  return cloud;
}

TEST(CloudSurface, MeasuresToTheSurfaceBetweenThePoints) {
  const double radius = 0.084;
  const double spacing = 0.004;
  const PointCloud cloud = cylinder_cloud(radius, 0.3, spacing, true);
  const Result<DesignSurface> surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  // A tangent plane leaves a cylinder by l^2 / 2R at an offset l; the blended neighbours lie within
  // about 1.2 spacings: 0.14 mm. Point to point would be off by up to 2.4 mm here.
  const double bend = 1.44 * spacing * spacing / (2 * radius);
  for (int i = 0; i < 3000; ++i) {
    const double angle = std::numbers::pi * uniform(random);
    const double height = 0.006 * uniform(random);
    const double z = 0.15 + 0.12 * uniform(random);
    const Eigen::Vector3d query((radius + height) * std::cos(angle),
                                (radius + height) * std::sin(angle), z);
    const auto found = surface->closest(query.cast<float>(), 0.05F);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, height, bend);
    EXPECT_EQ(found->part, 0);
  }
}

TEST(CloudSurface, LaysTheTangentPlaneThroughTheNearestPointAlone) {
  const double spacing = 0.004;
  const PointCloud cloud = cylinder_cloud(0.084, 0.3, spacing, true);
  const Result<DesignSurface> surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  std::mt19937 random(8);
  int differ = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3f query = random_in(random, 0.1F) + Eigen::Vector3f(0, 0, 0.15F);
    const auto found = surface->closest_tangent(query, 0.05F);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < cloud.size(); ++k)
      if ((cloud.points[k] - query).norm() < (cloud.points[nearest] - query).norm()) nearest = k;
    const Eigen::Vector3f offset = query - cloud.points[nearest];
    ASSERT_EQ(found.has_value(), offset.norm() < 0.05F);
    if (!found) continue;
    const float height = cloud.normals[nearest].dot(offset);
    const float aside = (offset - height * cloud.normals[nearest]).norm();
    // Past 1.5 spacings aside the surface has ended, as closest() has it.
    if (aside < 0.004F) {
      EXPECT_NEAR(found->distance, height, kFloat);
    }
    const auto blended = surface->closest(query, 0.05F);
    ASSERT_TRUE(blended);
    if (std::abs(blended->distance - found->distance) > 1e-5F) ++differ;
  }
  EXPECT_GT(differ, 100);  // the blend is another answer
}

TEST(CloudSurface, EstimatesNormalsWhereThereAreNone) {
  const double radius = 0.084;
  const PointCloud cloud = cylinder_cloud(radius, 0.3, 0.004, false);
  const Result<DesignSurface> surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  for (double angle = 0; angle < 6.28; angle += 0.1) {
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3d query = (radius + 0.003) * out + Eigen::Vector3d(0, 0, 0.1503);
    const auto found = surface->closest(query.cast<float>(), 0.05F);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::abs(found->distance), 0.003, 2e-4);  // the bend above and the normals' own
    EXPECT_GT(std::abs(found->normal.cast<double>().dot(out)), std::cos(0.05));
  }
}

TEST(CloudSurface, EndsWhereItsPointsEnd) {
  const PointCloud cloud = cylinder_cloud(0.084, 0.3, 0.004, true);
  const Result<DesignSurface> surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  // 50 mm past the end the tangent plane still passes near, the surface does not.
  const auto found = surface->closest({0.084F, 0, -0.05F}, 0.2F);
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::abs(found->distance), 0.05, 1e-3);
  EXPECT_FALSE(surface->closest({0.084F, 0, -0.05F}, 0.04F));
  EXPECT_FALSE(surface->cast({1, 0, 0.1F}, {-1, 0, 0}, 5));
}

}  // namespace
}  // namespace spool::test
