// Claims about keeping a pose from frame to frame, against known truth.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/frame_processor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"

namespace spool {
namespace {

FrameProcessor processor() {
  NoiseModel noise;
  noise.constant_m = 0.0008;  // half a millimetre drawn, and the rounding to whole millimetres
  return {test::prepared_bracket(), test::small_camera(), noise, {.stride_px = 1}};
}

VisionStatePtr run(FrameProcessor& vision, std::shared_ptr<const DepthFrame> frame) {
  auto state = vision.process(std::move(frame));
  EXPECT_TRUE(state.has_value());
  return state ? *state : nullptr;
}

std::shared_ptr<const DepthFrame> frame_at(const Pose& T, std::int64_t index) {
  return test::render_frame(*test::prepared_bracket(), T, index);
}

// Thousands of points of 1 mm leave hundredths of a millimetre; the pixel grid at the edges leaves
// the rest.
void expect_pose(const Pose& measured, const Pose& truth) {
  const PoseSize error = pose_size(truth.inverse() * measured);
  EXPECT_LT(error.translation_m, 0.0015);
  EXPECT_LT(error.rotation_rad, 0.004);
}

Pose off_by_picks(const Pose& T) {
  Vector6d small;
  small << 0.010, -0.008, 0.006, 0.02, -0.03, 0.02;
  return pose_from_small(small) * T;
}

TEST(FrameProcessor, ShowsACloudWithoutNumbersBeforeAnAlignment) {
  FrameProcessor vision = processor();
  const auto state = run(vision, frame_at(test::T_design_camera(), 0));
  EXPECT_EQ(state->quality, TrackQuality::kUnaligned);
  EXPECT_GT(state->scan.size(), 10000U);
  EXPECT_TRUE(state->scan_design.empty());
  EXPECT_TRUE(state->coverage.parts.empty());
}

TEST(FrameProcessor, FollowsAWalkingCameraAfterPicksOffByACentimetre) {
  FrameProcessor vision = processor();
  const Pose first = test::T_design_camera();
  const auto held = run(vision, frame_at(first, 0));
  const auto aligned = vision.align(*held, off_by_picks(first));
  ASSERT_EQ(aligned->quality, TrackQuality::kGood) << aligned->hint << aligned->agreement;
  expect_pose(aligned->T_design_camera, first);
  for (int i = 1; i <= 10; ++i) {
    const Pose truth = test::T_design_camera(0.01 * i, 0.004 * i);  // 7 mm a frame
    const auto state = run(vision, frame_at(truth, i));
    ASSERT_EQ(state->quality, TrackQuality::kGood) << "frame " << i << ": " << state->hint;
    expect_pose(state->T_design_camera, truth);
  }
}

TEST(FrameProcessor, EverythingOfAStateBelongsToItsFrame) {
  FrameProcessor vision = processor();
  const Pose T = test::T_design_camera();
  const auto held = run(vision, frame_at(T, 7));
  const auto state = vision.align(*held, T);
  ASSERT_TRUE(state->is_tracked());
  EXPECT_EQ(state->frame->index, 7);
  EXPECT_EQ(state->alignment, held->alignment + 1);
  ASSERT_EQ(state->scan_design.size(), state->scan.size());
  ASSERT_EQ(state->deviations.distance_m.size(), state->scan.size());
  ASSERT_EQ(state->classes.size(), state->scan.size());
  ASSERT_EQ(state->coverage.parts.size(), test::prepared_bracket()->model.parts.size());
  ASSERT_EQ(state->coverage.sight.size(), state->coverage.patches->all().size());
  for (std::size_t i = 0; i < state->scan.size(); i += 97) {
    const Eigen::Vector3f moved = state->T_design_camera.cast<float>() * state->scan.points[i];
    EXPECT_LT((moved - state->scan_design.points[i]).norm(), 1e-5F);
  }
}

TEST(FrameProcessor, APartsNumberIsOfAllFramesAndBeginsAnewWithAnAlignment) {
  FrameProcessor vision = processor();
  const auto pose = [](int i) { return test::T_design_camera(0.012 * i); };
  const auto not_seen = [](const VisionState& of) {
    return std::ranges::count(of.coverage.sight, PatchSight::kNotSeen);
  };
  const auto held = run(vision, frame_at(pose(0), 0));
  auto state = vision.align(*held, pose(0));
  ASSERT_TRUE(state->is_tracked());
  const auto not_seen_at_first = not_seen(*state);
  for (int i = 1; i <= 50; ++i) state = run(vision, frame_at(pose(i), i));
  ASSERT_TRUE(state->is_tracked()) << state->hint;
  for (const PartReading& part : state->coverage.parts) {
    EXPECT_TRUE(part.is_seen);
    // Nothing is wrong with this bracket; a flat face of rounded millimetres is off by some tenths.
    EXPECT_LT(std::abs(part.mean_m), part.u_m + 0.0004);
  }
  // It went round by half a radian: a twentieth of the surface more.
  const auto patches = static_cast<long>(state->coverage.sight.size());
  EXPECT_LT(not_seen(*state), not_seen_at_first - patches / 20);
  EXPECT_LT(state->coverage.parts[0].coverage, 0.7) << "nobody saw its underside";
  const auto again = vision.align(*state, pose(50));
  EXPECT_GT(not_seen(*again), not_seen(*state));
}

TEST(FrameProcessor, SaysLostWhenTheSpoolIsGoneAndFindsItAgainWhereItWas) {
  FrameProcessor vision = processor();
  const Pose T = test::T_design_camera();
  const auto held = run(vision, frame_at(T, 0));
  ASSERT_TRUE(vision.align(*held, T)->is_tracked());
  const auto lost = run(vision, test::empty_frame(T, 1));
  EXPECT_EQ(lost->quality, TrackQuality::kLost);
  EXPECT_FALSE(lost->hint.empty());
  EXPECT_TRUE(lost->scan_design.empty()) << "nothing is measured at a pose that is not believed";
  expect_pose(lost->T_design_camera, T);  // the last believed one
  const auto back = run(vision, frame_at(T, 2));
  EXPECT_EQ(back->quality, TrackQuality::kGood) << back->hint << back->pose_u_m;
}

TEST(FrameProcessor, RefusesAnAlignmentThatTheFrameContradicts) {
  FrameProcessor vision = processor();
  const Pose T = test::T_design_camera();
  const auto held = run(vision, frame_at(T, 0));
  Pose wrong = T;
  wrong.translation() += Eigen::Vector3d(0.3, 0.3, 0.25);  // half a metre off, in the air
  const auto state = vision.align(*held, wrong);
  EXPECT_EQ(state->quality, TrackQuality::kUnaligned);
  EXPECT_NE(state->hint.find("pick it again"), std::string::npos);
  const auto next = run(vision, frame_at(T, 1));
  EXPECT_EQ(next->quality, TrackQuality::kUnaligned);
  EXPECT_EQ(next->hint, state->hint) << "the reason stays on the screen";
}

// A plate on a bare floor: nothing but the plate holds the camera, and no map can be begun.
TEST(FrameProcessor, FollowsTheSpoolAloneWhereTheSceneIsTooPlain) {
  const auto plate = test::prepared_plate();
  NoiseModel noise;
  noise.constant_m = 0.0008;
  FrameProcessor vision(plate, test::small_camera(), noise, {.stride_px = 1});
  const Pose first = test::T_design_camera();
  const auto held = run(vision, test::render_frame(*plate, first, 0));
  EXPECT_EQ(held->camera, PoseQuality::kLost);
  ASSERT_TRUE(vision.align(*held, off_by_picks(first))->is_tracked());
  for (int i = 1; i <= 10; ++i) {
    const Pose truth = test::T_design_camera(0.005 * i, 0.002 * i);
    const auto state = run(vision, test::render_frame(*plate, truth, i));
    ASSERT_EQ(state->quality, TrackQuality::kGood) << "frame " << i << ": " << state->hint;
    expect_pose(state->T_design_camera, truth);
  }
}

// A camera that walks slowly to and fro in the workshop while the bracket may be moved about in it.
struct Workshop {
  FrameProcessor vision = processor();
  Pose T_shop_design = Pose::Identity();
  int frames = 0;
  VisionStatePtr last;

  [[nodiscard]] Pose T_shop_camera() const {
    return test::T_design_camera(0.15 * std::sin(0.05 * frames), 0.01 * std::sin(0.09 * frames));
  }
  [[nodiscard]] Pose truth() const { return T_shop_design.inverse() * T_shop_camera(); }
  VisionStatePtr see(bool is_there = true) {
    ++frames;
    last = run(vision, test::render_in_workshop(is_there ? test::prepared_bracket().get() : nullptr,
                                                T_shop_design, T_shop_camera(), frames));
    return last;
  }
  void begin() {
    const auto held = see();
    ASSERT_TRUE(vision.align(*held, off_by_picks(truth()))->is_tracked());
    for (int i = 0; i < 15; ++i) see();
    ASSERT_EQ(last->quality, TrackQuality::kGood) << last->hint;
    expect_pose(last->T_design_camera, truth());
  }
  [[nodiscard]] PoseSize off() const {
    return pose_size(truth().inverse() * last->T_design_camera);
  }
};

TEST(FrameProcessor, CarriesPicksOnToWhereTheCameraWentMeanwhile) {
  FrameProcessor vision = processor();
  const auto seen_from = [](const Pose& T, int frame) {
    return test::render_in_workshop(test::prepared_bracket().get(), Pose::Identity(), T, frame);
  };
  const Pose first = test::T_design_camera();
  const auto held = run(vision, seen_from(first, 0));
  Pose last = first;
  for (int i = 1; i <= 12; ++i) {  // 0.1 m and 7 degrees in all: out of reach of one step
    last = test::T_design_camera(0.01 * i, 0.004 * i);
    static_cast<void>(run(vision, seen_from(last, i)));
  }
  ASSERT_TRUE(vision.align(*held, off_by_picks(first))->is_tracked());
  const auto now = run(vision, seen_from(last, 13));
  ASSERT_EQ(now->quality, TrackQuality::kGood) << now->hint;
  expect_pose(now->T_design_camera, last);
}

TEST(FrameProcessor, NoticesABumpAndAlignsAgainWithinASecond) {
  const std::vector<Vector6d> bumps = {
      (Vector6d() << 0.02, 0, 0, 0, 0, 0).finished(),
      (Vector6d() << 0, -0.014, 0.014, 0, 0, 0).finished(),
      (Vector6d() << 0, 0, 0, 0, 0, 0.0873).finished(),  // 5 degrees about the vertical
  };
  for (const Vector6d& bump : bumps) {
    Workshop shop;
    shop.begin();
    shop.T_shop_design = pose_from_small(bump);
    for (int i = 0; i < 30; ++i) shop.see();
    EXPECT_EQ(shop.last->quality, TrackQuality::kGood) << shop.last->hint;
    expect_pose(shop.last->T_design_camera, shop.truth());
  }
}

TEST(FrameProcessor, SaysThatASpoolSetDownElsewhereIsNotWhereItWas) {
  Workshop shop;
  shop.begin();
  shop.T_shop_design = pose_from_small((Vector6d() << 0.1, 0.08, 0, 0, 0, 1.0).finished());
  for (int i = 0; i < 15; ++i) shop.see();
  EXPECT_EQ(shop.last->quality, TrackQuality::kLost);
  EXPECT_EQ(shop.last->camera, PoseQuality::kGood) << "the scene is still known";
  EXPECT_TRUE(shop.last->is_gone);
  EXPECT_NE(shop.last->hint.find("not where it was"), std::string::npos) << shop.last->hint;
  EXPECT_TRUE(shop.last->scan_design.empty())
      << "nothing is measured at a pose that is not believed";
}

TEST(FrameProcessor, GoesOnWhereTheSpoolIsOutOfSight) {
  Workshop shop;
  shop.begin();
  const Pose aside = test::T_design_camera(0.1);
  // The camera turns away to the crate, frame by frame, and back.
  for (int i = 0; i <= 30; ++i) {
    Pose T = aside;
    T.linear() =
        T.linear() *
        Eigen::AngleAxisd(-0.55 * std::sin(0.105 * i), Eigen::Vector3d::UnitY()).toRotationMatrix();
    shop.last = run(shop.vision, test::render_in_workshop(test::prepared_bracket().get(),
                                                          Pose::Identity(), T, 100 + i));
    ASSERT_TRUE(shop.last->is_tracked()) << i << shop.last->hint;
    const PoseSize off = pose_size(T.inverse() * shop.last->T_design_camera);
    EXPECT_LT(off.translation_m, 0.003) << i;
  }
  EXPECT_EQ(shop.last->quality, TrackQuality::kGood) << shop.last->hint;
}

TEST(FrameProcessor, RefusesAFrameOfAnotherSize) {
  FrameProcessor vision = processor();
  auto frame = std::make_shared<DepthFrame>();
  frame->index = 4;
  frame->width = 2;
  frame->height = 2;
  frame->depth.assign(4, 1000);
  const auto state = vision.process(frame);
  ASSERT_FALSE(state.has_value());
  EXPECT_EQ(state.error().code, ErrorCode::kBadInput);
  EXPECT_NE(state.error().message.find("frame 4 is 2x2 and the camera 160x120"), std::string::npos);
}

}  // namespace
}  // namespace spool
