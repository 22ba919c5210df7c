// Pictures that go out for a moment: waited for, not lost; those that stay out are not waited for.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "tools/campaign/depth_video.h"
#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene_design.h"
#include "tools/campaign/scene_room.h"
#include "vision/live/dropout_watch.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

std::mt19937& dice() {
  static std::mt19937 random{11};
  return random;
}

// A picture of which about `share` is measured.
DepthFrame picture(double share, double seconds) {
  DepthFrame frame{.seconds = seconds, .width = 160, .height = 120};
  std::bernoulli_distribution is_measured(share);
  for (int i = 0; i < 160 * 120; ++i)
    frame.depth.push_back(is_measured(dice()) ? std::uint16_t{1000} : std::uint16_t{0});
  return frame;
}

// How many of the next pictures are out.
struct Watched {
  DropoutWatch watch;
  double now_s = 0, period_s = 1.0 / 30;

  int show(int pictures, const std::function<double()>& share) {
    int out = 0;
    for (int i = 0; i < pictures; ++i) out += watch.is_out(picture(share(), now_s += period_s));
    return out;
  }
  int show(int pictures, double share) {
    return show(pictures, [share] { return share; });
  }
};

TEST(DropoutWatch, WaitsForAFlashAndGoesOnWithTheFirstPictureAfterIt) {
  for (const double fps : {5.0, 30.0, 90.0}) {
    SCOPED_TRACE(fps);
    Watched camera{.period_s = 1 / fps};
    EXPECT_EQ(camera.show(40, 0.8), 0);
    const int flash = static_cast<int>(std::ceil(0.5 * fps));
    EXPECT_EQ(camera.show(flash, 0.1), flash);
    EXPECT_EQ(camera.show(1, 0.8), 0);
    EXPECT_EQ(camera.show(flash, 0.0), flash) << "the arc is struck again at once";
    EXPECT_EQ(camera.show(10, 0.8), 0);
  }
}

TEST(DropoutWatch, WaitsForASecondAndNoLonger) {
  Watched camera;
  camera.show(40, 0.8);
  const int out = camera.show(90, 0.02);
  EXPECT_GE(out, 29);
  EXPECT_LE(out, 32);
  EXPECT_EQ(camera.show(60, 0.8), 0);
  EXPECT_EQ(camera.show(10, 0.02), 10) << "and learns anew what is usual";
}

TEST(DropoutWatch, WaitsNoLongerWhereTheClockStandsOrGoesBack) {
  for (const double step : {0.0, -1.0, std::nan("")}) {
    SCOPED_TRACE(step);
    Watched camera;
    camera.show(40, 0.8);
    camera.period_s = step;
    EXPECT_LE(camera.show(200, 0.02), 90);
  }
}

TEST(DropoutWatch, LeavesAloneWhatLosesLittleOrSlowly) {
  Watched camera;
  camera.show(40, 0.8);
  EXPECT_EQ(camera.show(10, 0.5), 0) << "a hand before the lens";
  double share = 0.8;
  EXPECT_EQ(camera.show(40, [&] { return share *= 0.9; }), 0) << "a camera that turns to the door";
  EXPECT_EQ(Watched().show(40, 0.0), 0) << "a lens that was covered all along";
}

TEST(DropoutWatch, TakesFlickerForUsualWhereItIs) {
  Watched camera;
  bool is_low = false;
  const auto flickers = [&] { return (is_low = !is_low) ? 0.3 : 0.8; };
  camera.show(30, flickers);
  EXPECT_EQ(camera.show(60, flickers), 0);
}

// The picture as an arc leaves it: a few readings, and those of anything.
std::shared_ptr<const DepthFrame> blinded(const DepthFrame& frame) {
  auto out = std::make_shared<DepthFrame>(frame);
  std::uniform_int_distribution<int> any(0, 99), depth(400, 4000);
  for (std::uint16_t& count : out->depth)
    count = any(dice()) < 3 ? static_cast<std::uint16_t>(depth(dice())) : std::uint16_t{0};
  return out;
}

// In a workshop, by hand: aligned and followed until the pose is good.
struct Shop {
  FrameProcessor vision{
      test::prepared_bracket(), test::small_camera(), {.constant_m = 0.0008}, {.stride_px = 1}};
  int frame = 0, place = 0;
  Pose truth = Pose::Identity();

  static Pose hand(int i) { return test::T_design_camera(0.008 * i, 0.002 * i); }  // 0.15 m/s
  VisionStatePtr show(bool is_blind, bool moves = true) {
    truth = hand(place);
    place += moves ? 1 : 0;
    const auto seen =
        test::render_in_workshop(test::prepared_bracket().get(), Pose::Identity(), truth, frame);
    auto timed = std::make_shared<DepthFrame>(is_blind ? *blinded(*seen) : *seen);
    timed->seconds = frame++ / 30.0;
    return *vision.process(std::move(timed));
  }
  void begin() {
    const auto first = show(false);
    ASSERT_TRUE(vision.align(*first, truth)->is_tracked());
    for (int i = 0; i < 15; ++i) {
      const auto state = show(false);
      ASSERT_TRUE(state->is_tracked()) << i << state->hint;
    }
  }
};

TEST(Dropout, AnArcPausesTheWorkWhichGoesOnAtOnce) {
  Shop shop;
  ASSERT_NO_FATAL_FAILURE(shop.begin());
  const Pose before = shop.truth;
  for (int i = 0; i < 12; ++i) {
    const auto state = shop.show(true);
    EXPECT_EQ(state->quality, TrackQuality::kPaused) << i;
    EXPECT_EQ(name(state->quality), "poor");
    EXPECT_TRUE(state->is_out);
    EXPECT_FALSE(state->is_tracked()) << "no numbers of a picture that shows nothing";
    EXPECT_TRUE(state->deviations.distance_m.empty());
    EXPECT_FALSE(state->hint.empty());
    EXPECT_LT(pose_size(before.inverse() * state->T_design_camera).translation_m, 0.003);
  }
  const auto after = shop.show(false);  // 0.4 s and 8 cm further on
  ASSERT_TRUE(after->is_tracked()) << after->hint;
  EXPECT_LT(pose_size(shop.truth.inverse() * after->T_design_camera).translation_m, 0.003);
  int good = 0;
  for (int i = 0; i < 10; ++i) good += shop.show(false)->quality == TrackQuality::kGood ? 1 : 0;
  EXPECT_GE(good, 8);
}

TEST(Dropout, ACoveredLensIsLostAfterASecondAndFoundAgain) {
  Shop shop;
  ASSERT_NO_FATAL_FAILURE(shop.begin());
  int paused = 0;
  VisionStatePtr state;
  for (int i = 0; i < 60; ++i) {
    state = shop.show(true, i % 4 == 0);  // the hand is slow meanwhile
    paused += state->quality == TrackQuality::kPaused ? 1 : 0;
  }
  EXPECT_GE(paused, 29);
  EXPECT_LE(paused, 32);
  EXPECT_NE(state->quality, TrackQuality::kPaused);
  EXPECT_FALSE(state->is_tracked()) << state->hint;
  bool found = false;
  for (int i = 0; i < 20 && !found; ++i) found = shop.show(false)->is_tracked();
  EXPECT_TRUE(found);
}

TEST(Dropout, PausesBeforeAnAlignmentToo) {
  Shop shop;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(shop.show(false)->is_out);
  const auto state = shop.show(true);
  EXPECT_TRUE(state->is_out);
  EXPECT_EQ(state->quality, TrackQuality::kUnaligned);
  EXPECT_NE(shop.show(false)->camera, PoseQuality::kLost);
}

// A hand that goes round a spool in a room, filmed as a driver would: an arc every second.
TEST(Dropout, ArcsDoNotLoseASpoolThatIsFollowedByHand) {
  campaign::SceneRequest request{.kind = campaign::ObjectKind::kRandomSpool, .seed = 3};
  const campaign::SceneRoom room = campaign::make_room(request);
  auto design = campaign::prepare_design(room.scene);
  ASSERT_TRUE(design.has_value());
  const campaign::RayWorld world(room.placed);
  campaign::HandheldSettings settings;
  settings.pixel_step = 4;
  const Camera camera = campaign::camera_of(settings);
  const campaign::HandMotion hand(world, room.object, {}, 3);
  Pose T_design_scan = room.scene.objects.front().T_scan_design.inverse();
  T_design_scan.pretranslate(-(*design)->model.origin);
  FrameProcessor vision(*design, camera, NoiseModel{}, {.stride_px = 1});
  int lost = 0, paused = 0, wrong = 0;
  for (int i = 0; i < 75; ++i) {
    const double now = i / 30.0;
    const Pose T_scan_camera = hand.T_scan_camera(now), truth = T_design_scan * T_scan_camera;
    auto filmed = std::make_shared<DepthFrame>(
        campaign::film(world, nullptr, settings, T_scan_camera, 3, i, now));
    const bool is_arc = i % 30 >= 20 && i % 30 < 27;
    VisionStatePtr state = *vision.process(is_arc ? blinded(*filmed) : filmed);
    if (i == 0) {
      state = vision.align(*state, truth);
      ASSERT_TRUE(state->is_tracked()) << state->hint;
    }
    EXPECT_EQ(state->quality == TrackQuality::kPaused, is_arc) << i << state->hint;
    paused += state->quality == TrackQuality::kPaused ? 1 : 0;
    lost += state->quality == TrackQuality::kLost ? 1 : 0;
    const bool is_off = pose_size(truth.inverse() * state->T_design_camera).translation_m > 0.02;
    wrong += state->is_tracked() && is_off ? 1 : 0;
  }
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(paused, 14);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace spool
