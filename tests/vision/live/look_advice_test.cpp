// Claims about what the fitter is told to do so that more is known.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/live/look_advice.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/vision/live/placed_states.h"

namespace spool {
namespace {

struct Adviser {
  NoiseModel noise = test::millimetre_noise();
  const PreparedDesign& design = *test::prepared_bracket();
  std::shared_ptr<const SurfacePatches> patches =
      SurfacePatches::cut(design.samples, design.model.parts.size());
  PatchReadings readings{patches, test::small_camera(), noise};
  LookAdviser adviser{design.model, *design.surface, test::small_camera(), noise};
  LookAdvice last = {};
  std::set<std::string> said = {};

  void see(const Pose& T, int i, const std::optional<NextLook>& next = {},
           const test::ChangeFrame& change = {}) {
    const VisionState state = test::placed_state(T, T, i, change);
    readings.add(state, Matrix6d::Zero());
    last = adviser.advise(state, readings, next);
    said.insert(last.text);
  }
};

Pose from_further(double metres) {
  Pose T = test::T_design_camera();
  T.translation() -= metres * T.linear().col(2);
  return T;
}

TEST(LookAdviser, HasNothingToSayWhileAllGoesWell) {
  Adviser adviser;
  for (int i = 0; i < 5; ++i) adviser.see(test::walking(i), i);
  EXPECT_EQ(adviser.said, std::set<std::string>{""});
}

TEST(LookAdviser, SaysWhatIsWrong) {
  const auto all_lost = [](DepthFrame& frame) {
    std::fill(frame.depth.begin(), frame.depth.end(), std::uint16_t{0});
  };
  const auto all_before = [](DepthFrame& frame) {
    std::fill(frame.depth.begin(), frame.depth.end(), std::uint16_t{550});
  };
  Adviser bright;
  for (int i = 0; i < 10; ++i) bright.see(test::T_design_camera(), i, {}, all_lost);
  EXPECT_EQ(bright.adviser.trouble(), LookTrouble::kTooBright);
  EXPECT_NE(bright.last.text.find("shade it"), std::string::npos);
  Adviser near;
  for (int i = 0; i < 10; ++i) near.see(from_further(-0.5), i, {}, all_lost);
  EXPECT_EQ(near.adviser.trouble(), LookTrouble::kTooNear);
  Adviser hidden;
  for (int i = 0; i < 10; ++i) hidden.see(test::T_design_camera(), i, {}, all_before);
  EXPECT_EQ(hidden.adviser.trouble(), LookTrouble::kHidden);
}

// By the noise of a real sensor: 5 mm at 2 m.
TEST(LookAdviser, SaysCloserWhereNoiseIsTooLarge) {
  Adviser far{NoiseModel{}};
  for (int i = 0; i < 10; ++i) far.see(from_further(1.2), i);
  EXPECT_EQ(far.adviser.trouble(), LookTrouble::kTooFar);
  EXPECT_EQ(far.last.text.rfind("Closer", 0), 0U);
}

TEST(LookAdviser, SaysSlowerWhereThePictureSmears) {
  Adviser fast;
  // To and fro by 60 mm a frame, 1.8 m/s.
  for (int i = 0; i < 10; ++i) fast.see(from_further(i % 2 == 0 ? 0 : 0.06), i);
  EXPECT_EQ(fast.adviser.trouble(), LookTrouble::kTooFast);
}

TEST(LookAdviser, SaysMoveOnWhereTheCameraStandsStill) {
  Adviser still{NoiseModel{}};  // of which one look is not enough
  for (int i = 0; i < 60; ++i) still.see(test::T_design_camera(), i);
  EXPECT_EQ(still.adviser.trouble(), LookTrouble::kTooStill);
}

TEST(LookAdviser, OneFrameChangesNothing) {
  Adviser adviser;
  for (int i = 0; i < 6; ++i) adviser.see(test::walking(i), i);
  adviser.see(test::walking(6), 6, {}, [](DepthFrame& frame) {
    std::fill(frame.depth.begin(), frame.depth.end(), std::uint16_t{0});
  });
  EXPECT_EQ(adviser.said, std::set<std::string>{""});
}

TEST(LookAdviser, TellsTheWayAsTheFitterSeesIt) {
  Adviser adviser;
  int i = 0;
  for (; i < 60; ++i) adviser.see(test::walking(i), i);  // all in sight is known
  const Pose T = test::T_design_camera();
  NextLook next;
  next.part = 1;
  next.target = {0.04F, 0.1F, 0.1F};
  const auto told = [&](const Eigen::Vector3d& in_camera) {
    next.direction = (T.linear() * in_camera.normalized()).cast<float>();
    adviser.see(T, i++, next);
    return adviser.last.text;
  };
  EXPECT_EQ(told({1, 0, -0.3}), "Next: look at arm from further right.");
  EXPECT_EQ(told({-1, 0, -0.3}), "Next: look at arm from further left.");
  EXPECT_EQ(told({0, -1, -0.3}), "Next: look at arm from above.");
  EXPECT_EQ(told({0, 0, 1}), "Next: look at arm from the other side.");
  EXPECT_EQ(adviser.last.part, 1);
  ASSERT_TRUE(adviser.last.target.has_value());
  // Between two ways what was said stays.
  EXPECT_EQ(told({1, 0, -0.3}), "Next: look at arm from further right.");
  EXPECT_EQ(told({1, -1.05, -0.3}), "Next: look at arm from further right.");
}

}  // namespace
}  // namespace spool
