// Stored views: the one that looks like the frame comes first, and their number is bounded.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/stored_views.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/vision/scan/seen_room.h"

namespace spool {
namespace {

using Eigen::Vector3d;

Pose round_the_room(int step) {
  const double angle = -2.8 + 0.12 * step;
  const Vector3d middle(0.2, 0.3, 0.1);
  return test::looking(middle + Vector3d(std::cos(angle), std::sin(angle), 0.6), middle);
}

struct Stored {
  Camera camera = test::small_camera();
  test::Room room = test::Room::furnished();
  StoredViews views;

  void offer(const Pose& T_room_camera) {
    const PointCloud cloud = test::see(room, camera, T_room_camera, 1);
    views.offer({cloud, camera, {}, 0}, T_room_camera);
  }
  [[nodiscard]] std::vector<Pose> likest(const Pose& T_room_camera, std::size_t most) const {
    const PointCloud cloud = test::see(room, camera, T_room_camera, 2);
    return views.likest({cloud, camera, {}, 0}, most);
  }
};

TEST(StoredViews, KeepOneOfViewsThatAreNearlyTheSame) {
  Stored stored;
  stored.offer(round_the_room(0));
  Pose near = round_the_room(0);
  near.translation().x() += 0.05;
  stored.offer(near);
  EXPECT_EQ(stored.views.size(), 1U);
  near.translation().x() += 0.1;  // 15 cm from the first
  stored.offer(near);
  EXPECT_EQ(stored.views.size(), 2U);
  near.rotate(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()));  // 17 degrees
  stored.offer(near);
  EXPECT_EQ(stored.views.size(), 3U);
}

TEST(StoredViews, GiveTheViewNextToWhereTheFrameWasTaken) {
  Stored stored;
  for (int i = 0; i < 20; i += 2) stored.offer(round_the_room(i));
  ASSERT_EQ(stored.views.size(), 10U);
  int nearest = 0;
  for (int i = 1; i < 19; i += 2) {
    const std::vector<Pose> poses = stored.likest(round_the_room(i), 3);
    ASSERT_EQ(poses.size(), 3U);
    // Between two stored views, 12 cm from each; the next ones are three times as far.
    for (int k = 0; k < 2; ++k)
      nearest += pose_size(poses[static_cast<std::size_t>(k)].inverse() * round_the_room(i))
                             .translation_m < 0.15
                     ? 1
                     : 0;
  }
  EXPECT_GE(nearest, 15);  // of 18: to be tried, not to be believed
}

TEST(StoredViews, HaveNothingInCommonWithAnEmptyFrame) {
  Stored stored;
  stored.offer(round_the_room(0));
  const PointCloud dark = test::cloud_of(
      stored.camera, std::vector<std::uint16_t>(static_cast<std::size_t>(stored.camera.width) *
                                                static_cast<std::size_t>(stored.camera.height)));
  EXPECT_TRUE(stored.views.likest({dark, stored.camera, {}, 0}, 5).empty());
}

}  // namespace
}  // namespace spool
