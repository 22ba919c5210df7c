// The tracker on a room of known truth: followed by hand, lost, found, and never wrong with `good`.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/tracker.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/scan/seen_room.h"

namespace spool {
namespace {

using Eigen::Vector3d;
using test::Room;

constexpr double kDegree = std::numbers::pi / 180;

// A hand that swings about the room's middle at up to 0.3 m/s and 25 degrees a second, with 3 mm
// and half a degree of tremor at 2 to 7 Hz.
Pose by_hand(double seconds) {
  const double angle = -2.2 + 0.3 * std::sin(0.9 * seconds);
  const Vector3d middle(0.3 + 0.05 * std::sin(seconds), 0.4, 0.15);
  const Vector3d eye =
      middle + Vector3d(0.95 * std::cos(angle), 0.95 * std::sin(angle), 0.45 + 0.05 * seconds);
  Vector6d tremor;
  const double a = 2 * std::numbers::pi * seconds;
  tremor << 0.002 * std::sin(2.3 * a), 0.002 * std::sin(3.1 * a + 1), 0.002 * std::sin(5.3 * a),
      0.005 * std::sin(2.9 * a), 0.005 * std::sin(4.1 * a + 2), 0.005 * std::sin(6.7 * a);
  return test::looking(eye, middle) * pose_from_small(tremor);
}

struct Following {
  Tracker tracker;
  Camera camera = test::small_camera();
  Room room = Room::furnished();
  Pose T_map_room = by_hand(0).inverse();
  unsigned seed = 1;

  TrackedPose see(const Pose& T_room_camera, double seconds) {
    const PointCloud cloud = test::see(room, camera, T_room_camera, seed++);
    return tracker.track({cloud, camera, {}, seconds});
  }
  TrackedPose show(const std::vector<std::uint16_t>& depth, double seconds) {
    const PointCloud cloud = test::cloud_of(camera, depth);
    return tracker.track({cloud, camera, {}, seconds});
  }
  [[nodiscard]] PoseSize off(const TrackedPose& tracked, const Pose& T_room_camera) const {
    return pose_size((T_map_room * T_room_camera).inverse() * tracked.T_map_camera);
  }
  [[nodiscard]] std::vector<std::uint16_t> depth(std::uint16_t counts) const {
    return std::vector<std::uint16_t>(
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height), counts);
  }
  // Follows the hand from `from_s` on; every frame has to be good and right.
  void follow(double from_s, double to_s, double fps = 30) {
    for (int i = 0; from_s + i / fps < to_s; ++i) {
      const double now = from_s + i / fps;
      const TrackedPose tracked = see(by_hand(now), now);
      const PoseSize error = off(tracked, by_hand(now));
      EXPECT_EQ(name(tracked.quality), "good") << now << " s: " << tracked.reason;
      EXPECT_LT(error.translation_m, 0.003) << now << " s";
      EXPECT_LT(error.rotation_rad, 0.3 * kDegree) << now << " s";
    }
  }
};

TEST(Tracker, FollowsAHandThatTrembles) {
  Following following;
  following.follow(0, 2);
  EXPECT_GT(following.tracker.map().size(), 3000U);
}

TEST(Tracker, FollowsAtAnyRateAndSizeOfPicture) {
  struct Case {
    const char* name;
    int width, height;
    double fps, seconds;
  };
  for (const Case& each :
       {Case{"5 fps", 160, 120, 5, 2}, Case{"90 fps", 160, 120, 90, 0.5},
        Case{"320x240", 320, 240, 30, 0.3}, Case{"1280x1024", 1280, 1024, 30, 0.1}}) {
    SCOPED_TRACE(each.name);
    Following following;
    following.camera = test::small_camera(each.width, each.height);
    following.follow(0, each.seconds, each.fps);
  }
}

TEST(Tracker, StatesAnUncertaintyThatItsErrorsKeepTo) {
  Following following;
  double sum = 0;
  int frames = 0;
  for (int i = 0; i < 45; ++i) {
    const double now = i / 30.0;
    const TrackedPose tracked = following.see(by_hand(now), now);
    if (i < 5) continue;
    // Error of the camera's place in the axes of the map.
    const Vector3d error =
        tracked.T_map_camera.translation() - (following.T_map_room * by_hand(now)).translation();
    const Eigen::Matrix3d covariance = tracked.covariance.topLeftCorner<3, 3>();
    sum += error.dot(covariance.inverse() * error);
    ++frames;
  }
  // Three degrees of freedom; the noise here is independent from pixel to pixel, where the tracker
  // has to reckon with a sensor that is not, and what the first frame was off by stays: between a
  // tenth and three times of what would be expected.
  EXPECT_LT(sum / frames, 9.0);
  EXPECT_GT(sum / frames, 0.3);
}

TEST(Tracker, IsLostUnderACoverAndBackWithinASecond) {
  Following following;
  following.follow(0, 1);
  const std::size_t size = following.tracker.map().size();
  for (int i = 0; i < 30; ++i) {
    const TrackedPose tracked = following.show(following.depth(0), 1 + i / 30.0);
    EXPECT_EQ(name(tracked.quality), "lost");
    EXPECT_FALSE(tracked.reason.empty());
  }
  EXPECT_EQ(following.tracker.map().size(), size);
  // The hand moved on meanwhile, by some 20 cm.
  int good = 0;
  for (int i = 0; i < 30; ++i) {
    const double now = 2 + i / 30.0;
    const TrackedPose tracked = following.see(by_hand(now), now);
    if (tracked.quality != PoseQuality::kGood) continue;
    ++good;
    EXPECT_GE(i, 3) << "a pose found anew has to be borne out first";
    EXPECT_LT(following.off(tracked, by_hand(now)).translation_m, 0.005);
  }
  EXPECT_GT(good, 15);
}

TEST(Tracker, NeverCallsAnotherRoomsPoseGood) {
  Following following;
  following.follow(0, 1);
  // Floor and walls as before, and none of the things on it where they were.
  following.room.boxes = {{Vector3d(-0.1, -0.3, 0), Vector3d(0.3, 0.0, 0.25)},
                          {Vector3d(0.4, -0.2, 0), Vector3d(0.6, 0.1, 0.4)}};
  following.room.balls = {{Vector3d(0.1, 0.6, 0.3), 0.3}};
  const std::size_t size = following.tracker.map().size();
  for (int i = 0; i < 30; ++i) {
    const double now = 1 + i / 30.0;
    const Pose elsewhere = test::looking({0.9 - 0.01 * i, -0.9, 0.5}, {0.2, 0.2, 0.1});
    const TrackedPose tracked = following.see(elsewhere, now);
    const PoseSize error = following.off(tracked, elsewhere);
    // The walls are the same: a pose that is right by them is right.
    if (error.translation_m > 0.02) {
      EXPECT_NE(name(tracked.quality), "good") << i;
    }
  }
  EXPECT_LT(following.tracker.map().size(), size + 20'000);
}

TEST(Tracker, HoldsWhatAFrameDoesNotHoldAndSaysSo) {
  // From the things to the edge between floor and wall alone: along the edge nothing is held. It
  // turns no farther than to where the last of the things leaves the view, for what is new there is
  // not taken into the map.
  Room room = Room::furnished();
  room.wall_y = false;
  Following following;
  following.room = room;
  const auto turned = [](int frame) {
    const double azimuth = (60 - 40 * std::min(1.0, frame / 45.0)) * kDegree;
    const Vector3d from(0.2, -0.5, 0.7);
    return test::looking(from, from + Vector3d(std::cos(azimuth), std::sin(azimuth), -0.75));
  };
  following.T_map_room = turned(0).inverse();
  TrackedPose tracked;
  double along_sigma = 0;
  for (int i = 0; i < 55; ++i) {
    tracked = following.see(turned(i), i / 30.0);
    const Vector3d along = following.T_map_room.linear() * Vector3d::UnitY();
    along_sigma = std::sqrt(along.dot(tracked.covariance.topLeftCorner<3, 3>() * along));
  }
  ASSERT_NE(name(tracked.quality), "lost") << tracked.reason;
  EXPECT_EQ(name(tracked.quality), "poor");
  ASSERT_EQ(tracked.weak_directions.size(), 1U);
  EXPECT_NE(tracked.reason.find("sliding along"), std::string::npos) << tracked.reason;
  EXPECT_GT(along_sigma, 0.01);
  // Across the edge it is as sure and as right as ever; along it, where the prediction put it.
  const Vector3d error =
      following.T_map_room.linear().transpose() *
      (tracked.T_map_camera.translation() - (following.T_map_room * turned(54)).translation());
  EXPECT_LT(std::hypot(error.x(), error.z()), 0.004);
  EXPECT_LT(std::abs(error.y()), 3 * along_sigma);
}

TEST(Tracker, StartsNoMapOnABareWall) {
  Following following;
  following.room = Room{.floor = false, .wall_x = true, .wall_y = false};
  for (int i = 0; i < 5; ++i) {
    const TrackedPose tracked = following.see(test::looking({0, 0, 0}, {1, 0, 0}), i / 30.0);
    EXPECT_EQ(name(tracked.quality), "lost");
    EXPECT_FALSE(tracked.reason.empty());
  }
  EXPECT_TRUE(following.tracker.map().empty());
}

TEST(Tracker, AnswersBadFramesWithAStatedQualityAndGoesOn) {
  std::mt19937 random{5};
  std::uniform_int_distribution<int> any(400, 3500);
  Following following;
  following.follow(0, 0.5);
  const std::size_t size = following.tracker.map().size();
  std::vector<std::uint16_t> noise = following.depth(0);
  for (std::uint16_t& counts : noise) counts = static_cast<std::uint16_t>(any(random));
  struct Case {
    const char* name;
    std::vector<std::uint16_t> depth;
  };
  double now = 0.5;
  for (const Case& each :
       {Case{"zeros", following.depth(0)}, Case{"one value", following.depth(900)},
        Case{"the largest", following.depth(65535)}, Case{"noise", noise}}) {
    SCOPED_TRACE(each.name);
    const TrackedPose tracked = following.show(each.depth, now += 1.0 / 30);
    EXPECT_NE(name(tracked.quality), "good");
    EXPECT_FALSE(tracked.reason.empty());
    EXPECT_TRUE(tracked.T_map_camera.matrix().allFinite());
    EXPECT_TRUE(tracked.covariance.allFinite());
  }
  Camera broken = following.camera;
  broken.fx = std::numeric_limits<double>::quiet_NaN();
  const PointCloud cloud = test::see(following.room, following.camera, by_hand(0.6), 1);
  EXPECT_EQ(name(following.tracker.track({cloud, broken, {}, now}).quality), "lost");
  EXPECT_EQ(name(following.tracker.track({PointCloud{}, following.camera, {}, now}).quality),
            "lost");
  EXPECT_EQ(following.tracker.map().size(), size);
  // And back.
  int good = 0;
  for (int i = 0; i < 20; ++i) {
    const double then = 0.7 + i / 30.0;
    const TrackedPose tracked = following.see(by_hand(then), then);
    good += tracked.quality == PoseQuality::kGood &&
                    following.off(tracked, by_hand(then)).translation_m < 0.004
                ? 1
                : 0;
  }
  EXPECT_GT(good, 12);
}

TEST(Tracker, TakesAClockThatGoesBackOrNowhere) {
  Following following;
  following.follow(0, 0.5);
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  int i = 0;
  for (const double clock : {0.5, 0.5, 0.1, -40.0, 1e9, kNaN, 0.0}) {
    const double now = 0.5 + i++ / 30.0;
    const TrackedPose tracked = following.see(by_hand(now), clock);
    EXPECT_EQ(name(tracked.quality), "good") << "clock " << clock << ": " << tracked.reason;
    EXPECT_LT(following.off(tracked, by_hand(now)).translation_m, 0.003) << "clock " << clock;
  }
}

TEST(Tracker, DoesNotWanderWithAParkedCamera) {
  Following following;
  following.camera = test::small_camera(80, 60);
  const Pose pose = by_hand(0);
  std::vector<PointCloud> clouds;
  for (unsigned i = 0; i < 40; ++i)
    clouds.push_back(test::see(following.room, following.camera, pose, i));
  Vector3d early = Vector3d::Zero(), late = Vector3d::Zero();
  constexpr int kFrames = 400;  // 13 seconds
  for (int i = 0; i < kFrames; ++i) {
    const TrackedPose tracked = following.tracker.track(
        {clouds[static_cast<std::size_t>(i * 7 % 40)], following.camera, {}, i / 30.0});
    ASSERT_EQ(name(tracked.quality), "good") << i << ": " << tracked.reason;
    if (i >= 40 && i < 80) early += tracked.T_map_camera.translation() / 40;
    if (i >= kFrames - 40) late += tracked.T_map_camera.translation() / 40;
  }
  // The same forty frames early and late: what the means differ by is the map's doing. In ten
  // minutes that would be 45 times as much at worst.
  EXPECT_LT((late - early).norm(), 0.0001);
}

TEST(Tracker, IsTheSameToTheLastBitEveryTime) {
  const auto run = [] {
    Following following;
    TrackedPose tracked;
    for (int i = 0; i < 12; ++i) tracked = following.see(by_hand(i / 30.0), i / 30.0);
    return tracked;
  };
  const TrackedPose first = run(), second = run();
  EXPECT_EQ(first.T_map_camera.matrix(), second.T_map_camera.matrix());
  EXPECT_EQ(first.covariance, second.covariance);
  EXPECT_EQ(first.score, second.score);
}

TEST(Tracker, RefusesOptionsThatMakeNoSense) {
  EXPECT_FALSE(validate(TrackerOptions{}));
  for (const TrackerOptions& options :
       {TrackerOptions{.map = {.cell_m = -1}}, TrackerOptions{.samples = 0},
        TrackerOptions{.good_m = 0}, TrackerOptions{.searches_per_frame = 0}})
    EXPECT_TRUE(validate(options));
}

}  // namespace
}  // namespace spool
