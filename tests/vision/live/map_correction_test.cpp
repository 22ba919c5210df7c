// What a closed loop moves the design by: the piece of map in the datum's box decides.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/map_correction.h"

#include <gtest/gtest.h>

#include "tests/vision/scan/seen_room.h"

namespace spool {
namespace {

using Eigen::Vector3d;

Pose along_x(double far_m) {
  Pose pose = Pose::Identity();
  pose.translation().x() = far_m;
  return pose;
}

// All cells hang on keyframe 1, which moves by 30 mm: more than a voxel, and less than a block.
struct MovedMap {
  ScanMap map;
  Eigen::AlignedBox3d before;
  std::vector<Pose> motions = {Pose::Identity(), along_x(0.03)};

  MovedMap() {
    const Camera camera = test::small_camera();
    const Pose T_room_camera = test::looking(Vector3d(-0.9, -0.6, 0.7), Vector3d(0.3, 0.4, 0.15));
    const PointCloud cloud = test::see(test::Room::furnished(), camera, T_room_camera, 1);
    map.fuse({cloud, camera, {}, 0}, Pose::Identity(), 1);
    for (const MapBlock& block : map.blocks())
      for (const MapCell& cell : block.cells) before.extend(cell.mean.cast<double>());
    map.move(motions);
  }
};

TEST(MapCorrection, IsThatOfThePieceWhichLayInTheBox) {
  const MovedMap moved;
  const Pose motion =
      motion_of_piece(moved.map, moved.motions, Pose::Identity(), moved.before, Pose::Identity());
  // Cells hold floats, and the box was theirs to the last bit.
  EXPECT_LT(pose_size(motion.inverse() * along_x(0.03)).translation_m, 1e-6);
}

TEST(MapCorrection, IsTheOtherWhereNothingOfTheMapLayInTheBox) {
  const MovedMap moved;
  const Vector3d past = moved.before.max() + Vector3d::Constant(0.01);
  // Moved cells lie in this box now; before, none did.
  const Eigen::AlignedBox3d box(Vector3d(past.x(), -10, -10), past + Vector3d::Constant(1));
  const Pose motion =
      motion_of_piece(moved.map, moved.motions, Pose::Identity(), box, along_x(0.007));
  EXPECT_LT(pose_size(motion.inverse() * along_x(0.007)).translation_m, 1e-12);
}

}  // namespace
}  // namespace spool
