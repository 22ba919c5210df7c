// Whatever a sensor gives: a stated quality, no crash, and no overlay that is made up.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"
#include "tools/campaign/depth_video.h"
#include "tools/campaign/hand_motion.h"
#include "tools/campaign/scene_design.h"
#include "tools/campaign/scene_room.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

FrameProcessor processor(const Camera& camera = test::small_camera()) {
  return {test::prepared_bracket(), camera, {.constant_m = 0.0008}, {.stride_px = 1}};
}

std::shared_ptr<DepthFrame> workshop(int index, double seconds) {
  auto frame = std::make_shared<DepthFrame>(*test::render_in_workshop(
      test::prepared_bracket().get(), Pose::Identity(), test::T_design_camera(), index));
  frame->seconds = seconds;
  return frame;
}

std::vector<std::uint16_t> noise(std::size_t pixels) {
  std::mt19937 random{5};
  std::uniform_int_distribution<int> any(400, 3500);
  std::vector<std::uint16_t> depth(pixels);
  for (std::uint16_t& count : depth) count = static_cast<std::uint16_t>(any(random));
  return depth;
}

TEST(BadInput, FramesOfNothingOfOneValueAndOfNoiseShowNoDesignAndAreGotOver) {
  const std::size_t pixels = std::size_t{160} * 120;
  struct Case {
    const char* name;
    std::vector<std::uint16_t> depth;
  };
  for (const Case& each : {Case{"zeros", std::vector<std::uint16_t>(pixels, 0)},
                           Case{"one value", std::vector<std::uint16_t>(pixels, 900)},
                           Case{"the largest", std::vector<std::uint16_t>(pixels, 65535)},
                           Case{"noise", noise(pixels)}}) {
    SCOPED_TRACE(each.name);
    FrameProcessor vision = processor();
    const Pose T = test::T_design_camera();
    ASSERT_TRUE(vision.align(**vision.process(workshop(0, 0)), T)->is_tracked());
    for (int i = 1; i < 10; ++i)
      ASSERT_TRUE((*vision.process(workshop(i, i / 30.0)))->is_tracked());
    for (int i = 10; i < 60; ++i) {
      auto bad = workshop(i, i / 30.0);
      bad->depth = each.depth;
      const auto state = vision.process(bad);
      ASSERT_TRUE(state.has_value());
      EXPECT_FALSE((*state)->is_tracked()) << i << ": an overlay on nothing";
      EXPECT_TRUE((*state)->scan_design.empty());
      EXPECT_FALSE((*state)->hint.empty());
      EXPECT_TRUE((*state)->T_design_camera.matrix().allFinite());
    }
    VisionStatePtr state;
    for (int i = 60; i < 75; ++i) state = *vision.process(workshop(i, i / 30.0));
    EXPECT_EQ(state->quality, TrackQuality::kGood) << state->hint;
    EXPECT_LT(pose_size(T.inverse() * state->T_design_camera).translation_m, 0.002);
  }
}

TEST(BadInput, AClockThatStandsGoesBackOrIsNoNumberChangesNothing) {
  FrameProcessor vision = processor();
  const Pose T = test::T_design_camera();
  ASSERT_TRUE(vision.align(**vision.process(workshop(0, 0)), T)->is_tracked());
  for (int i = 1; i < 10; ++i) static_cast<void>(vision.process(workshop(i, i / 30.0)));
  int index = 10;
  for (const double clock : {0.3, 0.3, 0.1, -40.0, 1e9, kNaN, 0.0}) {
    const auto state = *vision.process(workshop(index++, clock));
    EXPECT_EQ(state->quality, TrackQuality::kGood) << clock << ": " << state->hint;
    EXPECT_LT(pose_size(T.inverse() * state->T_design_camera).translation_m, 0.002) << clock;
  }
}

TEST(BadInput, IntrinsicsThatAreNoNumbersAreRefusedInASentence) {
  for (double Camera::*field :
       {&Camera::fx, &Camera::fy, &Camera::cx, &Camera::cy, &Camera::depth_unit_m}) {
    for (const double value : {kNaN, std::numeric_limits<double>::infinity()}) {
      Camera camera = test::small_camera();
      camera.*field = value;
      FrameProcessor vision = processor(camera);
      const auto state = vision.process(workshop(0, 0));
      ASSERT_FALSE(state.has_value());
      EXPECT_EQ(state.error().code, ErrorCode::kBadInput);
      EXPECT_NE(state.error().message.find("intrinsics"), std::string::npos);
    }
  }
}

TEST(BadInput, ADesignThatIsNotInTheSceneIsNotAlignedAnywhere) {
  FrameProcessor vision = processor();
  const Pose T = test::T_design_camera();
  const auto empty = [&](int i) {
    return test::render_in_workshop(nullptr, Pose::Identity(), T, i);
  };
  VisionStatePtr held = *vision.process(empty(0));
  // Picks on the floor, on the crate, in the air.
  for (const Eigen::Vector3d& off :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, -0.10), Eigen::Vector3d(-0.35, -0.15, 0),
        Eigen::Vector3d(0.3, 0.3, 0.3)}) {
    const auto state = vision.align(*held, Pose(Eigen::Translation3d(-off)) * T);
    EXPECT_EQ(state->quality, TrackQuality::kUnaligned) << off.transpose();
    EXPECT_TRUE(state->scan_design.empty());
    EXPECT_FALSE(state->hint.empty());
    const auto next = *vision.process(empty(1));
    EXPECT_FALSE(next->is_tracked());
  }
}

// Filmed by hand as sensors of other sizes and rates do.
TEST(BadInput, OtherSizesAndRatesAreFollowedAsWell) {
  struct Case {
    const char* name;
    int width, height, pixel_step, stride_px;
    double fps;
    int frames;
  };
  campaign::SceneRequest request{.kind = campaign::ObjectKind::kRandomSpool, .seed = 3};
  const campaign::SceneRoom room = campaign::make_room(request);
  auto design = campaign::prepare_design(room.scene);
  ASSERT_TRUE(design.has_value());
  const campaign::RayWorld world(room.placed);
  const campaign::HandMotion hand(world, room.object, {}, 3);
  Pose T_design_scan = room.scene.objects.front().T_scan_design.inverse();
  T_design_scan.pretranslate(-(*design)->model.origin);
  for (const Case& each :
       {Case{"5 fps", 640, 480, 4, 1, 5, 8}, Case{"90 fps", 640, 480, 4, 1, 90, 20},
        Case{"320x240", 320, 240, 1, 2, 30, 8}, Case{"1280x1024", 1280, 1024, 1, 4, 30, 2}}) {
    SCOPED_TRACE(each.name);
    campaign::HandheldSettings settings;
    settings.width = each.width;
    settings.height = each.height;
    settings.focal_px = 575.0 * each.width / 640;
    settings.pixel_step = each.pixel_step;
    const Camera camera = campaign::camera_of(settings);
    FrameProcessor vision(*design, camera, NoiseModel{}, {.stride_px = each.stride_px});
    int tracked = 0;
    for (int i = 0; i < each.frames; ++i) {
      const double now = i / each.fps;
      const Pose T_scan_camera = hand.T_scan_camera(now), truth = T_design_scan * T_scan_camera;
      auto state = vision.process(std::make_shared<DepthFrame>(
          campaign::film(world, nullptr, settings, T_scan_camera, 3, i, now)));
      ASSERT_TRUE(state.has_value()) << state.error().message;
      VisionStatePtr shown = *state;
      if (i == 0) shown = vision.align(*shown, truth);
      if (!shown->is_tracked()) continue;
      ++tracked;
      EXPECT_LT(pose_size(truth.inverse() * shown->T_design_camera).translation_m, 0.02) << i;
    }
    EXPECT_GE(tracked, each.frames * 4 / 5);
  }
}

}  // namespace
}  // namespace spool
