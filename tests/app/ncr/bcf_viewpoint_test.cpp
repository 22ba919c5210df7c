// The camera of a viewpoint, against a projection that is worked out here by itself.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/bcf_viewpoint.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace spool::test {
namespace {

using Eigen::Vector3d;

TEST(BcfViewpoint, TurnsYUpIntoZUp) {
  // East, up and south of a design are x, z and -y of a model: three points known by hand.
  EXPECT_EQ(ncr::z_up({1, 0, 0}), Vector3d(1, 0, 0));
  EXPECT_EQ(ncr::z_up({0, 1, 0}), Vector3d(0, 0, 1));
  EXPECT_EQ(ncr::z_up({0, 0, 1}), Vector3d(0, -1, 0));
}

TEST(BcfViewpoint, ReadsWhereAPictureIsSeenFrom) {
  EXPECT_TRUE(ncr::eye_side("seen from +x")->isApprox(Vector3d(1, 0, 0)));
  EXPECT_TRUE(ncr::eye_side("seen from -x +z")->isApprox(Vector3d(-1, 0, 1).normalized()));
  for (const char* text : {"", "seen from", "seen from the sensor", "seen from +w", "from +x"})
    EXPECT_FALSE(ncr::eye_side(text)) << text;
}

TEST(BcfViewpoint, HasAllOfTheDesignInItsPictureFromEverySide) {
  const Vector3d low(500, -1, 30), high(503, 0.5, 30.2);  // a plant's coordinates, m
  const Eigen::AlignedBox3d bounds(low, high);
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      for (int k = -1; k <= 1; ++k) {
        if (i == 0 && j == 0 && k == 0) continue;
        const ncr::BcfCamera camera = ncr::camera_at(bounds, Vector3d(i, j, k).normalized());
        ASSERT_NEAR(camera.direction.norm(), 1, 1e-12);
        ASSERT_NEAR(camera.up.norm(), 1, 1e-12);
        ASSERT_NEAR(camera.up.dot(camera.direction), 0, 1e-12);
        ASSERT_GE(camera.up.z(), -1e-12);
        const Vector3d right = camera.direction.cross(camera.up);
        double widest = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const double x = (corner & 1) != 0 ? high.x() : low.x();
          const double y = (corner & 2) != 0 ? high.y() : low.y();
          const double z = (corner & 4) != 0 ? high.z() : low.z();
          const Vector3d p = Vector3d(x, -z, y) - camera.view_point;  // north is -z
          const double depth = p.dot(camera.direction);
          ASSERT_GT(depth, 0) << "behind the camera";
          for (const double across : {p.dot(right), p.dot(camera.up)})
            widest = std::max(widest, std::abs(std::atan2(across, depth)));
        }
        EXPECT_LE(widest, 30 * M_PI / 180);  // half of 60 degrees
        // Not lost in the picture: the box is at least as wide as a third of it from its long
        // sides; from its ends it may be thin.
        EXPECT_GT(widest, 1.5 * M_PI / 180);
        // The side that the design's frame says.
        const Vector3d away = camera.view_point - Vector3d(501.5, -30.1, -0.25);
        EXPECT_EQ(std::abs(away.x()) < 1e-9 ? 0 : away.x() > 0 ? 1 : -1, i);
        EXPECT_EQ(std::abs(away.z()) < 1e-9 ? 0 : away.z() > 0 ? 1 : -1, j) << "y of the design";
        EXPECT_EQ(std::abs(away.y()) < 1e-9 ? 0 : away.y() < 0 ? 1 : -1, k) << "z of the design";
      }
    }
  }
}

TEST(BcfViewpoint, OfNothingThereIsStillACamera) {
  const ncr::BcfCamera camera = ncr::camera_at(Eigen::AlignedBox3d(), Vector3d::UnitX());
  EXPECT_TRUE(camera.view_point.allFinite());
  EXPECT_GT(camera.view_point.norm(), 0);
}

}  // namespace
}  // namespace spool::test
