// Loop closure on a room that was mapped twice, the second time with drift: pulled out, or refused.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/loop_closure.h"

#include <gtest/gtest.h>

#include "tests/vision/scan/seen_room.h"

namespace spool {
namespace {

using Eigen::Vector3d;

// The corner seen from one side, and by a way that drifted from the other, where the same box and
// drum are in view.
struct TwiceSeen {
  Camera camera = test::small_camera();
  test::Room room = test::Room::furnished();
  Pose T_room_first = test::looking(Vector3d(-0.9, -0.6, 0.7), Vector3d(0.3, 0.4, 0.15));
  Pose T_room_second = test::looking(Vector3d(-0.6, -0.9, 0.8), Vector3d(0.3, 0.4, 0.15));
  Pose T_map_room = T_room_first.inverse();
  ScanMap map;
  Keyframes keyframes{20};
  Pose drift = Pose::Identity();  // T_map_camera = drift * truth, of the second keyframe

  TwiceSeen(const Vector3d& drift_m, double stated_sigma) {
    drift.translation() = drift_m;
    keyframes.start(Matrix6d::Identity() * 1e-8);
    Vector6d sigma = Vector6d::Constant(stated_sigma);
    const Pose T_map_second = drift * T_map_room * T_room_second;
    const std::size_t second =
        keyframes.graph().add(0, keyframes.graph().T_map_keyframe(0).inverse() * T_map_second,
                              Matrix6d(sigma.cwiseAbs2().asDiagonal()));
    // A frame corrects the cells of the first look that it agrees with as well: few are enough.
    for (unsigned i = 0; i < 30; ++i) fuse(T_room_first, Pose::Identity(), 0, i);
    for (unsigned i = 30; i < 36; ++i)
      fuse(T_room_second, T_map_second, static_cast<KeyframeId>(second), i);
  }
  [[nodiscard]] PointCloud see(const Pose& T_room_camera, unsigned seed) const {
    return test::see(room, camera, T_room_camera, seed);
  }
  void fuse(const Pose& T_room_camera, const Pose& T_map_camera, KeyframeId keyframe,
            unsigned seed) {
    const PointCloud cloud = see(T_room_camera, 1 + seed);
    map.fuse({cloud, camera, {}, 0.1 * seed}, T_map_camera, keyframe);
  }
  // The edge that a frame from the second place makes.
  std::optional<PoseEdge> measure() {
    const Pose T_map_camera = keyframes.graph().T_map_keyframe(1);
    const Matrix6d of_fit = Matrix6d::Identity() * 1e-8;
    const auto candidate = find_loop(MapView(map, with_margin(camera, 160), T_map_camera),
                                     keyframes, T_map_camera, of_fit);
    if (!candidate) return std::nullopt;
    const PointCloud cloud = see(T_room_second, 999);
    const SeenFrame frame{cloud, camera, {}, 1};
    const FrameSamples samples = sample_frame(frame, ReadingNoise({}, camera), 7000);
    return measure_loop(samples, camera, *candidate, map, keyframes, T_map_camera);
  }
  [[nodiscard]] double off_m() const {
    return pose_size((T_map_room * T_room_second).inverse() * keyframes.graph().T_map_keyframe(1))
        .translation_m;
  }
};

TEST(LoopClosure, PullsOutTheDriftOfASecondLookAndMovesItsPieceOfTheMap) {
  TwiceSeen seen(Vector3d(0.012, -0.009, 0.01), 0.01);
  const PoseEdge edge{0, 1, seen.T_map_room * seen.T_room_second, Matrix6d::Identity() * 1e-6};
  ASSERT_GT(seen.off_m(), 0.015);
  const std::size_t cells = seen.map.size();
  const std::vector<Pose> motions = close_loop(edge, seen.keyframes, seen.map);
  ASSERT_EQ(motions.size(), 2U);
  // The edge is known to 1 mm, the drift to 10 mm: a hundredth of the drift is left.
  EXPECT_LT(seen.off_m(), 0.0005);
  EXPECT_GT(pose_size(motions[1]).translation_m, 0.015);
  EXPECT_LT(pose_size(motions[0]).translation_m, 0.0005);
  // What leaves its block finds a voxel that is taken now and then, no more.
  EXPECT_GT(seen.map.size(), cells * 9 / 10);
  // The steel is where it is: the floor of the second look lies on that of the first.
  const Pose T_room_map = seen.T_map_room.inverse();
  double sum = 0;
  std::size_t count = 0;
  for (const MapBlock& block : seen.map.blocks())
    for (const MapCell& cell : block.cells) {
      if (cell.keyframe != 1) continue;
      const Vector3d there = T_room_map * cell.mean.cast<double>();
      const Vector3d normal = T_room_map.linear() * cell.normal.cast<double>();
      if (normal.z() < 0.95 || there.z() > 0.05) continue;
      sum += there.z();
      ++count;
    }
  ASSERT_GT(count, 100U);
  EXPECT_NEAR(sum / static_cast<double>(count), 0, 0.002);  // the sensor's noise, averaged
}

TEST(LoopClosure, MeasuresWhatLiesBetweenTwoLooks) {
  TwiceSeen seen(Vector3d(0.012, -0.009, 0.01), 0.01);
  seen.keyframes.set_current(1);
  const auto edge = seen.measure();
  ASSERT_TRUE(edge.has_value());
  EXPECT_EQ(edge->from, 0U);
  EXPECT_EQ(edge->to, 1U);
  const Vector6d off = small_between(seen.T_map_room * seen.T_room_second, edge->T_from_to);
  EXPECT_LT(off.head<3>().norm(), 0.004);  // of 18 mm
  // Three standard deviations of each axis, as it says itself.
  for (int k = 0; k < 6; ++k)
    EXPECT_LT(std::abs(off[k]), 3 * std::sqrt(edge->covariance(k, k))) << k;
  ASSERT_FALSE(close_loop(*edge, seen.keyframes, seen.map).empty());
  EXPECT_LT(seen.off_m(), 0.004);
}

TEST(LoopClosure, RefusesAPlaceThatOnlyLooksTheSame) {
  // The second place lies 18 mm from where the first is, and the way there is known to 1 mm: it
  // is a copy of it, 18 mm on.
  TwiceSeen seen(Vector3d(0.012, -0.009, 0.01), 0.001);
  const PoseEdge edge{0, 1, seen.T_map_room * seen.T_room_second, Matrix6d::Identity() * 1e-6};
  const double off = seen.off_m();
  EXPECT_TRUE(close_loop(edge, seen.keyframes, seen.map).empty());
  EXPECT_DOUBLE_EQ(seen.off_m(), off);
}

TEST(LoopClosure, LooksForNoneWhereAllHangsTogether) {
  TwiceSeen seen(Vector3d::Zero(), 0.0001);  // m and rad: as sure as a fit is
  seen.keyframes.set_current(1);
  EXPECT_FALSE(seen.measure().has_value());
}

// However long the way: so many keyframes, and every cell hangs on one that is there.
TEST(Keyframes, AreBounded) {
  const Camera camera = test::small_camera();
  const test::Room room = test::Room::furnished();
  const Pose T_room_camera = test::looking(Vector3d(-0.9, -0.6, 0.7), Vector3d(0.3, 0.4, 0.15));
  const PointCloud cloud = test::see(room, camera, T_room_camera, 1);
  ScanMap map;
  Keyframes keyframes(6);
  const Matrix6d covariance = Matrix6d::Identity() * 1e-8;
  keyframes.start(covariance);
  KeyframeId on = 0;
  double last = 0;
  for (unsigned i = 0; i < 40; ++i) {
    Pose T = Pose::Identity();
    T.translation().x() = 0.15 * i;
    const std::vector<KeyframeShare> shares = {{on, 100}};
    if (i > 0) on = keyframes.hang(T, shares, covariance, map);
    map.fuse({cloud, camera, {}, 0.1 * i}, T, on);
    ASSERT_LE(keyframes.graph().size(), 6U) << i;
    ASSERT_LT(on, keyframes.graph().size());
    const double now = keyframes.covariance_at(T, shares).trace();
    EXPECT_GE(now, 0.999 * last) << "what is far is known no better than what is near, " << i;
    last = now;
  }
  for (const MapBlock& block : map.blocks())
    for (const MapCell& cell : block.cells) ASSERT_LT(cell.keyframe, keyframes.graph().size());
}

}  // namespace
}  // namespace spool
