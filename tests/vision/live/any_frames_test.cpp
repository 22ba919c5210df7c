// Frames of every rate, size and kind of nonsense: a stated quality, no crash, no invented overlay.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

// A hand that walks round the bracket in the workshop at 0.15 m/s.
Pose by_hand(double seconds) {
  return test::T_design_camera(0.2 * std::sin(seconds), 0.02 * std::sin(1.7 * seconds));
}

struct Following {
  Camera camera = test::small_camera();
  int stride_px = 1;
  NoiseModel noise = [] {
    NoiseModel model;
    model.constant_m = 0.0008;  // half a millimetre drawn, and the rounding to whole millimetres
    return model;
  }();
  FrameProcessor vision{test::prepared_bracket(), camera, noise, {.stride_px = stride_px}};
  std::int64_t frames = 0;

  VisionStatePtr see(const Pose& truth, double clock_s) {
    auto frame = std::make_shared<DepthFrame>(*test::render_in_workshop(
        test::prepared_bracket().get(), Pose::Identity(), truth, frames++, camera));
    frame->seconds = clock_s;
    const auto state = vision.process(std::move(frame));
    EXPECT_TRUE(state.has_value());
    return *state;
  }
  VisionStatePtr show(std::vector<std::uint16_t> depth, double clock_s) {
    auto frame = std::make_shared<DepthFrame>();
    *frame = {frames++, clock_s, camera.width, camera.height, std::move(depth)};
    const auto state = vision.process(std::move(frame));
    EXPECT_TRUE(state.has_value());
    return *state;
  }
  [[nodiscard]] std::vector<std::uint16_t> depth(std::uint16_t counts) const {
    return std::vector<std::uint16_t>(
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height), counts);
  }
  void begin() {
    const auto held = see(by_hand(0), 0);
    ASSERT_TRUE(vision.align(*held, by_hand(0))->is_tracked());
  }
  // From `from_s` on; every pose is right, and the last ones are good.
  void follow(double from_s, double to_s, double fps) {
    VisionStatePtr state;
    for (int i = 0; from_s + i / fps < to_s; ++i) {
      const double now = from_s + i / fps;
      state = see(by_hand(now), now);
      ASSERT_TRUE(state->is_tracked()) << now << " s: " << state->hint;
      const PoseSize off = pose_size(by_hand(now).inverse() * state->T_design_camera);
      EXPECT_LT(off.translation_m, 0.003) << now << " s";
      EXPECT_LT(off.rotation_rad, 0.00524) << now << " s";  // 0.3 degrees
    }
    EXPECT_EQ(state->quality, TrackQuality::kGood) << state->hint;
  }
};

// What may be shown of a frame that means nothing: a reason, and never numbers at a pose that is
// not believed.
void expect_stated(const VisionState& state) {
  EXPECT_NE(state.quality, TrackQuality::kGood);
  EXPECT_FALSE(state.hint.empty());
  EXPECT_TRUE(state.T_design_camera.matrix().allFinite());
  EXPECT_TRUE(std::isfinite(state.pose_u_m) && std::isfinite(state.pose_u_rad));
  if (state.is_tracked()) return;
  EXPECT_TRUE(state.scan_design.empty());
  EXPECT_TRUE(state.coverage.parts.empty());
}

TEST(AnyFrames, AreFollowedAtFiveAndAtNinetyASecond) {
  struct Rate {
    double fps, seconds;
  };
  for (const Rate& rate : {Rate{5, 3}, Rate{90, 0.7}}) {
    SCOPED_TRACE(rate.fps);
    Following following;
    following.begin();
    following.follow(1 / rate.fps, rate.seconds, rate.fps);
  }
}

TEST(AnyFrames, AreFollowedInAnySize) {
  struct Size {
    double times;
    int stride_px;
    double seconds;
  };
  // 320x240, and as wide as 1280x1024.
  for (const Size& size : {Size{2, 2, 0.5}, Size{8, 2, 0.15}}) {
    SCOPED_TRACE(size.times);
    Following following{.camera = test::larger_camera(size.times), .stride_px = size.stride_px};
    following.begin();
    following.follow(1 / 30.0, size.seconds, 30);
  }
}

TEST(AnyFrames, ThatMeanNothingHaveAStatedQualityAndAreGotOver) {
  std::mt19937 random{5};
  std::uniform_int_distribution<int> any(400, 3500);
  Following following;
  following.begin();
  following.follow(1 / 30.0, 0.5, 30);
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
    for (int i = 0; i < 3; ++i) expect_stated(*following.show(each.depth, now += 1.0 / 30));
    // And back to what it is for, within half a second.
    VisionStatePtr state;
    for (int i = 0; i < 15; ++i) {
      now += 1.0 / 30;
      state = following.see(by_hand(now), now);
    }
    EXPECT_EQ(state->quality, TrackQuality::kGood) << state->hint;
    EXPECT_LT(pose_size(by_hand(now).inverse() * state->T_design_camera).translation_m, 0.003);
  }
}

TEST(AnyFrames, OfNothingBearNoAlignment) {
  for (const std::uint16_t counts : std::initializer_list<std::uint16_t>{0, 65535}) {
    SCOPED_TRACE(counts);
    Following following;
    const auto held = following.show(following.depth(counts), 0);
    EXPECT_EQ(held->quality, TrackQuality::kUnaligned);
    const auto state = following.vision.align(*held, by_hand(0));
    EXPECT_EQ(state->quality, TrackQuality::kUnaligned);
    EXPECT_FALSE(state->hint.empty());
    EXPECT_TRUE(state->scan_design.empty());
  }
}

// Who picks a bare wall for the flat of the bracket is told that it is unsure, and stays so.
TEST(AnyFrames, OfABareWallAreNeverGood) {
  Following following;
  const auto held = following.show(following.depth(900), 0);
  EXPECT_EQ(held->camera, PoseQuality::kLost) << "no map is begun on a wall";
  const auto aligned = following.vision.align(*held, by_hand(0));
  expect_stated(*aligned);
  for (int i = 1; i < 8; ++i) expect_stated(*following.show(following.depth(900), i / 30.0));
}

TEST(AnyFrames, MayBearAClockThatGoesBackOrNowhere) {
  Following following;
  following.begin();
  following.follow(1 / 30.0, 0.5, 30);
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  int i = 0;
  for (const double clock : {0.5, 0.5, 0.1, -40.0, 1e9, kNaN, kNaN, 0.0, 0.03}) {
    const double now = 0.5 + i++ / 30.0;
    const auto state = following.see(by_hand(now), clock);
    EXPECT_EQ(state->quality, TrackQuality::kGood) << "clock " << clock << ": " << state->hint;
    EXPECT_LT(pose_size(by_hand(now).inverse() * state->T_design_camera).translation_m, 0.003)
        << "clock " << clock;
  }
}

TEST(AnyFrames, OfACameraWithoutIntrinsicsAreRefused) {
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<Camera> broken(4, test::small_camera());
  broken[0].fx = kNaN;
  broken[1].cy = kNaN;
  broken[2].fy = 0;
  broken[3].depth_unit_m = std::numeric_limits<double>::infinity();
  for (const Camera& camera : broken) {
    FrameProcessor vision(test::prepared_bracket(), camera, NoiseModel{});
    const auto state = vision.process(test::render_frame(*test::prepared_bracket(), by_hand(0), 0));
    ASSERT_FALSE(state.has_value());
    EXPECT_EQ(state.error().code, ErrorCode::kBadInput);
    EXPECT_NE(state.error().message.find("intrinsics"), std::string::npos);
  }
}

// The bracket is not in the workshop: wherever it is said to lie, on the things that are there or
// in the air, no overlay comes of it, nor does one come by and by.
TEST(AnyFrames, OfAnotherSceneGetNoOverlay) {
  for (const Eigen::Vector3d& where :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(-0.42, -0.1, 0.0),  // the crate
        Eigen::Vector3d(0.0, 0.28, 0.05),                             // the shelf
        Eigen::Vector3d(0.5, -0.12, -0.05), Eigen::Vector3d(0.02, -0.35, -0.1)}) {
    SCOPED_TRACE(where.transpose());
    Following following;
    const auto see_workshop = [&] {
      const double now = static_cast<double>(following.frames) / 30.0;
      auto frame =
          test::render_in_workshop(nullptr, Pose::Identity(), by_hand(now), following.frames++);
      return *following.vision.process(std::move(frame));
    };
    const auto held = see_workshop();
    Pose T_guess = by_hand(0);
    T_guess.translation() -= where;
    const auto aligned = following.vision.align(*held, T_guess);
    EXPECT_EQ(aligned->quality, TrackQuality::kUnaligned) << aligned->agreement;
    for (int i = 0; i < 5; ++i) {
      const auto state = see_workshop();
      EXPECT_EQ(state->quality, TrackQuality::kUnaligned);
      EXPECT_TRUE(state->scan_design.empty());
    }
  }
}

TEST(AnyFrames, SayHowLongTheirStagesTookAndHowLargeTheMapIs) {
  Following following;
  following.begin();
  const auto state = following.see(by_hand(0.03), 0.03);
  for (const char* stage : {"thin", "follow", "follow/fit", "follow/fuse", "place", "deviation"})
    EXPECT_TRUE(state->timing_s.contains(stage)) << stage;
  EXPECT_LE(state->timing_s.at("follow/fit") + state->timing_s.at("follow/fuse"),
            state->timing_s.at("follow"));
  EXPECT_GT(state->map_cells, 1000U);
}

}  // namespace
}  // namespace spool
