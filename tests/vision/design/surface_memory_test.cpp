// Answers from memory against searches of every element, for queries that wander.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/design/surface_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/design/shapes.h"
#include "vision/design/closest_on_triangle.h"
#include "vision/design/design_surface.h"

namespace spool::test {
namespace {

using Eigen::Vector3f;

Vector3f gaussian(std::mt19937& random, float scale) {
  std::normal_distribution<float> normal(0, scale);
  const float x = normal(random), y = normal(random);
  return {x, y, normal(random)};
}

// Distance to the nearest of all triangles, one after the other.
float nearest_of_all(const DesignModel& design, const Vector3f& query) {
  float least = std::numeric_limits<float>::max();
  for (const Triangle& t : design.mesh.triangles) {
    const auto& v = design.mesh.vertices;
    least = std::min(
        least,
        closest_to_origin(v[t[0]] - query, v[t[1]] - query, v[t[2]] - query).point.squaredNorm());
  }
  return std::sqrt(least);
}

// Walks one query about, in steps from a micrometre to centimetres, with gates that open and close
// and margins from nothing to more than the walk needs, and calls `check(query, gate, margin)`.
template <class Check>
void wander(const Vector3f& start, std::mt19937& random, const Check& check) {
  std::uniform_real_distribution<float> unit(0, 1);
  Vector3f query = start;
  for (int step = 0; step < 40; ++step) {
    const float size = std::pow(10.0F, -6 + 4.5F * unit(random));
    query += gaussian(random, size);
    const float gate = step % 5 == 0 ? 0.002F : 0.05F * unit(random);
    check(query, gate, step % 3 == 0 ? 0.0F : 0.004F * unit(random));
  }
}

TEST(SurfaceMemory, OfTrianglesAnswersAsASearchOfAllDoes) {
  // Facets of 6 mm and of 0.3 m beside each other; edges, corners and a bore.
  DesignModel design = torus_design(0.1, 0.03, 96, 32);
  append_design(design, box_design({0.1, 0, 0}, {0.05, 0.15, 0.02}));
  const auto surface = DesignSurface::build(design);
  ASSERT_TRUE(surface);
  std::mt19937 random{1};
  int answered = 0, beyond = 0;
  for (int walk = 0; walk < 160; ++walk) {
    SurfaceMemory memory;
    wander(gaussian(random, 0.08F), random, [&](const Vector3f& query, float gate, float margin) {
      const auto plain = surface->closest(query, gate);
      const auto told = surface->closest(query, gate, margin, memory);
      ASSERT_EQ(told.has_value(), plain.has_value());
      EXPECT_EQ(surface->is_within(query, gate), plain.has_value());
      const float least = nearest_of_all(design, query);
      if (!told) {
        EXPECT_GE(least, gate);
        ++beyond;
        return;
      }
      ++answered;
      EXPECT_EQ(std::abs(told->distance), least);  // the same arithmetic, so the same bits
      EXPECT_EQ(told->distance, plain->distance);
      EXPECT_EQ(told->point, plain->point);
      EXPECT_EQ(told->normal, plain->normal);
      EXPECT_EQ(told->element, plain->element);
    });
  }
  EXPECT_GT(answered, 1000);
  EXPECT_GT(beyond, 1000);
}

TEST(SurfaceMemory, OfPointsAnswersAsASearchDoes) {
  // A sampled tube with gaps, so that some queries are past an edge; spacing some 4 mm.
  std::mt19937 random{2};
  std::uniform_real_distribution<float> unit(0, 1);
  PointCloud cloud;
  for (int i = 0; i < 6000; ++i) {
    const float angle = 6.2831853F * unit(random), along = 0.4F * unit(random);
    if (std::fmod(along, 0.1F) > 0.08F) continue;
    const Vector3f out(std::cos(angle), std::sin(angle), 0);
    cloud.points.push_back(0.04F * out + Vector3f(0, 0, along));
    cloud.normals.push_back(out);
  }
  const auto surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  int answered = 0;
  for (int walk = 0; walk < 200; ++walk) {
    SurfaceMemory memory;
    const Vector3f start = cloud.points[static_cast<std::size_t>(walk) * 20] +
                           gaussian(random, walk % 2 == 0 ? 0.002F : 0.02F);
    wander(start, random, [&](const Vector3f& query, float gate, float margin) {
      const auto plain = surface->closest(query, gate);
      const auto told = surface->closest(query, gate, margin, memory);
      float least = std::numeric_limits<float>::max();
      for (const Vector3f& p : cloud.points) least = std::min(least, (p - query).norm());
      ASSERT_EQ(told.has_value(), plain.has_value());
      EXPECT_EQ(surface->is_within(query, gate), plain.has_value());
      if (!told) {
        EXPECT_GE(least, gate * (1 - 1e-6F));
        return;
      }
      ++answered;
      EXPECT_EQ(told->element, plain->element);
      EXPECT_NEAR((cloud.points[told->element] - query).norm(), least, 1e-7F);
      // Sums of eight planes' heights in float: the last bits hang on how far the search went.
      EXPECT_NEAR(told->distance, plain->distance, 1e-7F);
      EXPECT_LT((told->normal - plain->normal).norm(), 1e-5F);
    });
  }
  EXPECT_GT(answered, 2000);
}

TEST(SurfaceMemory, OfFewerPointsThanItHoldsKnowsAll) {
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {0.01F, 0, 0}, {0, 0.01F, 0}};
  cloud.normals.assign(3, Vector3f::UnitZ());
  const auto surface = DesignSurface::build(CloudView(cloud));
  ASSERT_TRUE(surface);
  SurfaceMemory memory;
  EXPECT_TRUE(surface->closest({0, 0, 0.001F}, 0.01F, 0.001F, memory));
  const auto told = surface->closest({0.009F, 0, 0.001F}, 0.01F, 0.001F, memory);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->element, 1U);
  EXPECT_FALSE(surface->closest({0.5F, 0, 0}, 0.01F, 0.001F, memory));
  EXPECT_FALSE(surface->closest({std::nanf(""), 0, 0}, 0.01F, 0.001F, memory));
}

}  // namespace
}  // namespace spool::test
