// The scan map: noise averages out, what moves fades, what stands still is not worn out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/scan/scan_map.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/vision/scan/seen_room.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::Room;

const Vector3d kMiddle(0.25, 0.4, 0.1);

Room bare_wall() {
  Room room;
  room.floor = room.wall_y = false;
  return room;
}

// A wall at x = 1 seen from `x`, the camera moved a few millimetres from frame to frame.
Pose before_wall(double x, int frame) {
  const double sway = 0.005 * frame;
  return test::looking({x, 0.01 * std::sin(sway * 90), 0.01 * std::cos(sway * 70)}, {1, 0, 0});
}

struct Filming {
  ScanMap map;
  Camera camera = test::small_camera();
  int frames = 0;
  FuseReport last = {};

  void fuse(const Room& room, const Pose& T_room_camera, std::uint32_t seed) {
    const PointCloud cloud = test::see(room, camera, T_room_camera, seed);
    last = map.fuse({cloud, camera, {}, frames++ / 30.0}, T_room_camera);
  }
};

std::size_t settled_in(const ScanMap& map, const Eigen::AlignedBox3d& box) {
  std::size_t count = 0;
  for (const Eigen::Vector3f& point : map.cloud().points)
    count += box.contains(point.cast<double>()) ? 1U : 0U;
  return count;
}

double rms_off_wall(const ScanMap& map) {
  double sum = 0;
  const PointCloud cloud = map.cloud();
  for (const Eigen::Vector3f& point : cloud.points) {
    const double off = static_cast<double>(point.x()) - 1;
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(cloud.size()));
}

TEST(ScanMap, AveragesTheNoiseOutAndSaysHowFar) {
  Filming filming;
  for (int i = 0; i < 40; ++i) filming.fuse(bare_wall(), before_wall(0.1, i), 100U + unsigned(i));
  // 1.67 mm at 0.9 m, independent from frame to frame: 40 of them leave 0.26; cells come and go at
  // the picture's rim, so a third more.
  const double noise = NoiseModel{}.axial_m(0.9);
  EXPECT_LT(rms_off_wall(filming.map), 1.33 * noise / std::sqrt(40.0));
  double stated = 0, spread = 0, counted = 0;
  for (const MapBlock& block : filming.map.blocks())
    for (const MapCell& cell : block.cells) {
      if (cell.count < 35) continue;
      stated += std::sqrt(double{cell.variance()});
      spread += std::sqrt(double{cell.normal.dot(cell.covariance * cell.normal)});
      counted += 1;
      EXPECT_NEAR(cell.normal.norm(), 1, 1e-4);
      EXPECT_GT(-cell.normal.x(), 0.99);  // towards the camera
    }
  ASSERT_GT(counted, 500);
  // The mean's own deviation by the number of readings, a reading's by their spread; the angle of
  // view adds some percent to either.
  EXPECT_NEAR(stated / counted, noise / std::sqrt(40.0), 0.15 * noise / std::sqrt(40.0));
  EXPECT_NEAR(spread / counted, noise, 0.2 * noise);
}

TEST(ScanMap, KeepsOneSurfaceWhereNoiseReachesOverVoxels) {
  // At 1.4 m noise is 3.1 mm: a voxel of 8 mm would split it in two at its edge, seven sigma apart.
  Filming filming;
  for (int i = 0; i < 40; ++i) filming.fuse(bare_wall(), before_wall(-0.4, i), 300U + unsigned(i));
  std::size_t off = 0;
  const PointCloud cloud = filming.map.cloud();
  for (const Eigen::Vector3f& point : cloud.points)
    off += std::abs(point.x() - 1) > 0.004F ? 1U : 0U;
  ASSERT_GT(cloud.size(), 1000U);
  EXPECT_LT(off, cloud.size() / 100);
}

TEST(ScanMap, LetsWhatStoodThereFadeWithinASecond) {
  Room room = Room::furnished();
  Room with = room;
  const Eigen::AlignedBox3d thing(Vector3d(0.0, -0.1, 0.3), Vector3d(0.15, 0.1, 0.5));
  with.boxes.push_back(thing);
  const Eigen::AlignedBox3d near(thing.min() - Vector3d::Constant(0.01),
                                 thing.max() + Vector3d::Constant(0.01));
  Filming filming;
  const Pose pose = test::looking({-0.5, -0.6, 0.7}, kMiddle);
  for (int i = 0; i < 60; ++i) filming.fuse(with, pose, 1U + unsigned(i));
  ASSERT_GT(settled_in(filming.map, near), 100U);
  for (int i = 0; i < 30; ++i) filming.fuse(room, pose, 100U + unsigned(i));
  EXPECT_EQ(settled_in(filming.map, near), 0U);
  EXPECT_GT(settled_in(filming.map, {Vector3d(-1, -1, -0.01), Vector3d(1, 1, 0.01)}), 500U);
}

TEST(ScanMap, NeverSettlesOnWhatPassesBy) {
  const Room room = Room::furnished();
  Filming filming;
  const Pose pose = test::looking({-0.5, -0.6, 0.7}, kMiddle);
  for (int i = 0; i < 10; ++i) filming.fuse(room, pose, 1U + unsigned(i));
  const Eigen::AlignedBox3d air(Vector3d(-0.5, -0.25, 0.32), Vector3d(0.6, 0.15, 0.55));
  ASSERT_EQ(settled_in(filming.map, air), 0U);
  std::size_t most = 0;
  for (int i = 0; i < 30; ++i) {
    Room with = room;
    // 1 m/s, as a hook or a hand goes by.
    const double x = -0.45 + 0.033 * i;
    with.boxes.push_back({Vector3d(x, -0.1, 0.35), Vector3d(x + 0.1, 0.0, 0.45)});
    filming.fuse(with, pose, 100U + unsigned(i));
    most = std::max(most, settled_in(filming.map, air));
  }
  EXPECT_LT(most, 30U);  // its top, which slides in itself, for some frames
  for (int i = 0; i < 30; ++i) filming.fuse(room, pose, 200U + unsigned(i));
  EXPECT_EQ(settled_in(filming.map, air), 0U);
}

TEST(ScanMap, IsNotWornOutByAParkedCamera) {
  Filming filming;
  filming.camera = test::small_camera(80, 60);
  const Room room = Room::furnished();
  const Pose pose = test::looking({-0.5, -0.6, 0.7}, kMiddle);
  std::vector<PointCloud> clouds;
  for (unsigned i = 0; i < 50; ++i) clouds.push_back(test::see(room, filming.camera, pose, i));
  const auto park = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      const PointCloud& cloud = clouds[static_cast<std::size_t>(filming.frames) % clouds.size()];
      filming.last = filming.map.fuse({cloud, filming.camera, {}, filming.frames++ / 30.0}, pose);
    }
  };
  park(150);
  EXPECT_TRUE(filming.last.parked);
  const auto weights = [&] {
    double sum = 0;
    for (const MapBlock& block : filming.map.blocks())
      for (const MapCell& cell : block.cells) sum += double{cell.weight};
    return sum / static_cast<double>(filming.map.size());
  };
  const double weight = weights();
  const std::size_t size = filming.map.size();
  park(1800);  // a minute more
  EXPECT_LT(std::abs(weights() - weight), 0.03 * weight);
  EXPECT_NEAR(static_cast<double>(filming.map.size()), static_cast<double>(size),
              0.03 * static_cast<double>(size));
}

TEST(ScanMap, FollowsASurfaceThatMovedALittle) {
  // The wall comes 4 mm nearer, which is within the gate: no cell may be too sure to follow.
  Filming filming;
  const Pose pose = before_wall(0.2, 0);
  for (int i = 0; i < 200; ++i) filming.fuse(bare_wall(), pose, 1U + unsigned(i));
  Pose nearer = pose;
  nearer.translation().x() += 0.004;
  std::size_t restarted = 0;
  for (int i = 0; i < 40; ++i) {
    const PointCloud cloud = test::see(bare_wall(), filming.camera, nearer, 500U + unsigned(i));
    filming.last = filming.map.fuse({cloud, filming.camera, {}, filming.frames++ / 30.0}, pose);
    restarted += filming.last.restarted;
  }
  EXPECT_GT(restarted, 500U);
  double sum = 0;
  const PointCloud cloud = filming.map.cloud();
  for (const Eigen::Vector3f& point : cloud.points) sum += static_cast<double>(point.x());
  EXPECT_NEAR(sum / static_cast<double>(cloud.size()), 0.996, 0.001);
}

TEST(ScanMap, KeepsBothSidesOfAThinPlate) {
  Room plate;
  plate.floor = plate.wall_x = plate.wall_y = false;
  plate.boxes = {{Vector3d(-0.2, -0.002, -0.2), Vector3d(0.2, 0.002, 0.2)}};
  Filming filming;
  for (int i = 0; i < 20; ++i)
    filming.fuse(plate, test::looking({0.005 * i, -0.7, 0.01}, {0, 0, 0}), 1U + unsigned(i));
  for (int i = 0; i < 20; ++i)
    filming.fuse(plate, test::looking({0.005 * i, 0.7, 0.01}, {0, 0, 0}), 50U + unsigned(i));
  double front = 0, back = 0, front_y = 0, back_y = 0;
  const PointCloud cloud = filming.map.cloud();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::abs(cloud.points[i].x()) > 0.18F || std::abs(cloud.points[i].z()) > 0.18F) continue;
    const bool is_front = cloud.normals[i].y() < 0;
    (is_front ? front : back) += 1;
    (is_front ? front_y : back_y) += static_cast<double>(cloud.points[i].y());
  }
  // Were the sides one, their means would be alike. Depth counts are rounded to a millimetre.
  EXPECT_NEAR(front_y / front, -0.002, 0.0002);
  EXPECT_NEAR(back_y / back, 0.002, 0.0002);
  EXPECT_GT(front, 500);
  EXPECT_GT(back, 500);
}

TEST(ScanMap, MakesFinerCellsWhenTheCameraComesNear) {
  Filming filming;
  const auto largest_in_middle = [&] {
    float largest = 0;
    for (const MapBlock& block : filming.map.blocks())
      for (const MapCell& cell : block.cells)
        if (std::hypot(cell.mean.y(), cell.mean.z()) < 0.1F) largest = std::max(largest, cell.size);
    return largest;
  };
  for (int i = 0; i < 20; ++i) filming.fuse(bare_wall(), before_wall(-2, i), 1U + unsigned(i));
  EXPECT_GT(largest_in_middle(), 0.03F);  // noise at 3 m is 14 mm
  for (int i = 0; i < 60; ++i) filming.fuse(bare_wall(), before_wall(0.3, i), 50U + unsigned(i));
  EXPECT_LT(largest_in_middle(), 0.01F);
}

TEST(ScanMap, StaysWithinItsMemory) {
  Filming filming;
  filming.map = ScanMap({.most_cells = 3000});
  const Room room = Room::furnished();
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.04 * i;
    filming.fuse(room,
                 test::looking({-0.9 + 0.02 * i, -0.9, 0.8},
                               {0.3 + std::sin(angle), 0.3 - std::cos(angle) * 0.3, 0}),
                 1U + unsigned(i));
    EXPECT_LE(filming.map.size(), 3000U);
  }
  // What is in view now is what was kept.
  EXPECT_GT(filming.last.agreed, 500U);
}

TEST(ScanMap, IsTheSameToTheLastBitEveryTime) {
  const auto film = [] {
    Filming filming;
    for (int i = 0; i < 10; ++i)
      filming.fuse(Room::furnished(), test::looking({-0.5 + 0.01 * i, -0.6, 0.7}, kMiddle),
                   1U + unsigned(i));
    return filming.map.cloud();
  };
  const PointCloud first = film(), second = film();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first.points[i], second.points[i]);
    EXPECT_EQ(first.normals[i], second.normals[i]);
  }
}

TEST(ScanMap, RefusesOptionsThatMakeNoSense) {
  EXPECT_FALSE(validate(ScanMapOptions{}));
  for (const ScanMapOptions& options :
       {ScanMapOptions{.cell_m = 0}, ScanMapOptions{.most_cells = 0},
        ScanMapOptions{.most_count = 1}, ScanMapOptions{.unsettled_s = 0}})
    EXPECT_TRUE(validate(options));
}

}  // namespace
}  // namespace spool
