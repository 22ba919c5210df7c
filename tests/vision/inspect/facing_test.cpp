// Claims about readings of faces that the sensor cannot see.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/inspect/facing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace spool {
namespace {

// A plate of 1 m x 1 m, 0.1 m thick, its top at z = 0.
DesignModel plate() {
  DesignModel model;
  Part part;
  part.name = "plate";
  for (int c = 0; c < 8; ++c) {
    model.mesh.vertices.emplace_back((c & 1) != 0 ? 1.0F : 0.0F, (c & 2) != 0 ? 1.0F : 0.0F,
                                     (c & 4) != 0 ? 0.0F : -0.1F);
  }
  model.mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                          {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  part.triangle_count = 12;
  model.triangle_part.assign(12, 0);
  model.parts = {part};
  return model;
}

TEST(Facing, AFloorUnderThePartIsNotThePart) {
  const DesignModel model = plate();
  const auto surface = DesignSurface::build(model);
  ASSERT_TRUE(surface.has_value());
  const std::vector<Eigen::Vector3f> points{
      {0.5F, 0.5F, 0.015F},   // bulges towards the sensor: a defect
      {0.5F, 0.5F, -0.015F},  // dented away from it: a defect too
      {0.5F, 0.5F, -0.115F},  // the floor, nearest to the underside
      {0.5F, 0.5F, -0.102F},  // the underside within the noise: cannot be told
  };
  std::vector<PointClass> classes(points.size(), PointClass::kObject);
  Deviations deviations = measure_deviations(CloudView(points), classes, *surface, 0.03F);
  const std::size_t dropped =
      drop_turned_away(CloudView(points), {0.5, 0.5, 2.0}, *surface, 0.005F, classes, deviations);
  EXPECT_EQ(dropped, 1U);
  EXPECT_EQ(classes, (std::vector{PointClass::kObject, PointClass::kObject, PointClass::kClutter,
                                  PointClass::kObject}));
  EXPECT_NEAR(deviations.distance_m[0], 0.015F, 1e-6F);
  EXPECT_NEAR(deviations.distance_m[1], -0.015F, 1e-6F);
  EXPECT_TRUE(std::isnan(deviations.distance_m[2]));
  EXPECT_EQ(deviations.part[2], -1);
}

TEST(Facing, FromBelowTheUndersideCounts) {
  const DesignModel model = plate();
  const auto surface = DesignSurface::build(model);
  ASSERT_TRUE(surface.has_value());
  const std::vector<Eigen::Vector3f> points{{0.5F, 0.5F, -0.115F}};
  std::vector<PointClass> classes{PointClass::kObject};
  Deviations deviations = measure_deviations(CloudView(points), classes, *surface, 0.03F);
  EXPECT_EQ(
      drop_turned_away(CloudView(points), {0.5, 0.5, -2.0}, *surface, 0.005F, classes, deviations),
      0U);
}

}  // namespace
}  // namespace spool
