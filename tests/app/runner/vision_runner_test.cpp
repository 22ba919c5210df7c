// The threads together: states out of frames, commands answered, everything ended at any moment.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/vision_runner.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "app/runner/feed.h"
#include "tests/app/runner/simulated_scene.h"

namespace spool {
namespace {

using std::chrono::milliseconds;

FrameProcessor processor() {
  NoiseModel noise;
  noise.constant_m = 0.0008;
  return {test::prepared_bracket(), test::small_camera(), noise, {.stride_px = 1}};
}

std::unique_ptr<sensor::DepthSource> standing_still(int frames, bool recording) {
  const Pose T = test::T_design_camera();
  std::vector<test::Step> steps;
  for (int i = 0; i < frames; ++i) {
    steps.push_back(test::frame_step(test::render_frame(*test::prepared_bracket(), T, i)));
    steps.back().delay = milliseconds(5);
  }
  return std::make_unique<test::ScriptedSource>(std::move(steps), recording);
}

// Asks the feed until `wanted` holds for a state; nothing when it never does.
template <class Wanted>
VisionStatePtr wait_for(Feed& feed, const Wanted& wanted) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < deadline) {
    if (VisionStatePtr state = feed.poll(); state && wanted(*state)) return state;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return nullptr;
}

TEST(LiveFeed, AlignsOnTheHeldFrameAndTracksOn) {
  const auto feed = make_live_feed(standing_still(40, false), processor());
  const auto first = wait_for(*feed, [](const VisionState&) { return true; });
  ASSERT_TRUE(first);
  feed->pause(true);
  feed->command({VisionCommand::Kind::kAlign, first, test::T_design_camera()});
  const auto answered = wait_for(*feed, [](const VisionState& s) { return s.alignment == 1; });
  ASSERT_TRUE(answered);
  EXPECT_TRUE(answered->is_tracked()) << answered->hint;
}

TEST(LiveFeed, AnswersAnAlignmentAfterTheRecordingEnded) {
  const auto feed = make_live_feed(standing_still(2, true), processor());
  const auto last = wait_for(*feed, [](const VisionState& s) { return s.frame->index == 1; });
  ASSERT_TRUE(last);
  feed->command({VisionCommand::Kind::kAlign, last, test::T_design_camera()});
  const auto answered = wait_for(*feed, [](const VisionState& s) { return s.alignment == 1; });
  ASSERT_TRUE(answered);
  EXPECT_EQ(answered->frame->index, 1);
}

TEST(LiveFeed, EndsInTheMiddleOfTheWork) {
  for (int i = 0; i < 5; ++i) {
    const auto feed = make_live_feed(standing_still(10, false), processor());
    std::this_thread::sleep_for(milliseconds(4 * i));
  }
}

TEST(LiveFeed, ReportsAFrameOfTheWrongSizeAndGoesOn) {
  auto wrong = std::make_shared<DepthFrame>();
  wrong->width = wrong->height = 1;
  wrong->depth = {1};
  std::vector<test::Step> steps{test::frame_step(wrong)};
  for (int i = 0; i < 3; ++i) {
    steps.push_back(test::frame_step(
        test::render_frame(*test::prepared_bracket(), test::T_design_camera(), i)));
    steps.back().delay = milliseconds(100);  // so that the wrong one is not overtaken
  }
  const auto feed =
      make_live_feed(std::make_unique<test::ScriptedSource>(std::move(steps), false), processor());
  ASSERT_TRUE(wait_for(*feed, [](const VisionState&) { return true; }));
  const auto note = feed->note();
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kTrouble);
  EXPECT_NE(note->words.find("1x1"), std::string::npos);
  const auto next = feed->note();
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->trouble, sensor::SensorTrouble::kNone) << "and that it is over";
}

TEST(LockStepFeed, TakesEveryFrameInOrderAndWaitsWhilePaused) {
  const auto feed = make_lock_step_feed(standing_still(4, true), processor());
  EXPECT_EQ(feed->poll()->frame->index, 0);
  EXPECT_EQ(feed->poll()->frame->index, 1);
  feed->pause(true);
  EXPECT_EQ(feed->poll(), nullptr);
  feed->pause(false);
  EXPECT_EQ(feed->poll()->frame->index, 2);
  EXPECT_EQ(feed->poll()->frame->index, 3);
  EXPECT_EQ(feed->poll(), nullptr);
  EXPECT_EQ(feed->take_track().size(), 4U);
  const auto note = feed->note();
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kEnded);
}

TEST(LockStepFeed, GivesTheSameStatesTwice) {
  const auto run = [] {
    const auto feed = make_lock_step_feed(standing_still(3, true), processor());
    const auto held = feed->poll();
    feed->command({VisionCommand::Kind::kAlign, held, test::T_design_camera()});
    std::vector<double> numbers;
    while (const auto state = feed->poll()) {
      for (const double number : row_major(state->T_design_camera)) numbers.push_back(number);
      numbers.push_back(state->rms_m);
    }
    return numbers;
  };
  const std::vector<double> once = run();
  EXPECT_EQ(once.size(), 3U * 17U);
  EXPECT_EQ(once, run());  // to the last bit
}

}  // namespace
}  // namespace spool
