// Ideal images against the formulas of a plane and a cylinder.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/tools/simulator/test_scene.h"

namespace spool::simulator {
namespace {

TEST(Caster, SeesATiltedPlaneWhereItIs) {
  const double tilt = 0.6, depth = 1.3;
  const auto simulator = open_scene(R"("clutter": [)" + plate(depth, tilt) + "]");
  ASSERT_TRUE(simulator) << simulator.error().message;
  const IdealImage image = simulator->ideal(0);
  const Camera& camera = simulator->scene().sensor.camera;
  // Turned by +tilt about the map's z: the face's normal is (sin t, -cos t, 0) in the map, so x sin
  // t - z cos t = -depth cos t in the camera, and the depth along a ray (x, y, 1) is linear in 1/z.
  for (int v = 0; v < camera.height; v += 37)
    for (int u = 0; u < camera.width; u += 23) {
      const Eigen::Vector3d ray = camera.back_project(u, v, 1);
      const double expected = depth * std::cos(tilt) / (std::cos(tilt) - ray.x() * std::sin(tilt));
      const auto pixel = static_cast<std::size_t>(v * camera.width + u);
      // Float vertices 10 m away carry 1e-6 m each.
      ASSERT_NEAR(image.depth[pixel], expected, 5e-6) << u << " " << v;
      const Eigen::Vector3d normal(std::sin(tilt), 0, -std::cos(tilt));
      const double angle = std::acos(-normal.dot(ray.normalized()));
      ASSERT_NEAR(image.incidence[pixel], angle, 1e-3);  // acos of a float near 1
    }
}

TEST(Caster, SeesACylinderWhereItIs) {
  const double radius = 0.08, depth = 0.9;
  const auto simulator = open_scene(
      R"("clutter": [{"kind": "cylinder", "diameter_m": 0.16, "length_m": 4, "position_m": [0.02, 0.9, 0]}])");
  ASSERT_TRUE(simulator) << simulator.error().message;
  const IdealImage image = simulator->ideal(0);
  const Camera& camera = simulator->scene().sensor.camera;
  int hits = 0;
  for (int v = 40; v < camera.height; v += 41)
    for (int u = 0; u < camera.width; u += 3) {
      const Eigen::Vector3d ray = camera.back_project(u, v, 1);
      // |(ray.x z - 0.02, z - depth)| = radius, the nearer solution.
      const double a = ray.x() * ray.x() + 1, b = ray.x() * 0.02 + depth,
                   c = 0.02 * 0.02 + depth * depth - radius * radius;
      const double discriminant = b * b - a * c;
      const auto pixel = static_cast<std::size_t>(v * camera.width + u);
      if (discriminant < -1e-4) {
        EXPECT_EQ(image.depth[pixel], 0) << u << " " << v;
      } else if (discriminant > 2e-4) {
        ++hits;
        const double expected = (b - std::sqrt(discriminant)) / a;
        // 256 facets lie up to radius (1 - cos(pi / 256)) = 6 um inside; seen at a slant of up to
        // 80 degrees.
        const double incidence = image.incidence[pixel];
        ASSERT_NEAR(image.depth[pixel], expected, 8e-6 / std::cos(incidence)) << u << " " << v;
      }
    }
  EXPECT_GT(hits, 300);
}

TEST(Caster, SeesTheNearerOfTwoBodies) {
  const auto simulator =
      open_scene(R"("clutter": [)" + plate(2) + "," +
                 R"({"kind": "box", "size_m": [0.2, 0.2, 0.2], "position_m": [0, 1, 0]}])");
  ASSERT_TRUE(simulator) << simulator.error().message;
  const IdealImage image = simulator->ideal(0);
  EXPECT_NEAR(image.depth[static_cast<std::size_t>(240 * 640 + 320)], 0.9, 1e-6);
  EXPECT_NEAR(image.depth[0], 2, 1e-5);
  EXPECT_EQ(image.part[0], -1);
}

TEST(Caster, SeesNothingBeyondItsReach) {
  const auto simulator = open_scene(R"("clutter": [)" + plate(5) + "]");
  ASSERT_TRUE(simulator) << simulator.error().message;
  EXPECT_EQ(simulator->ideal(0).depth[1000], 0);
}

}  // namespace
}  // namespace spool::simulator
