// The sensor's life: frames, unplugging, ends, failures, pauses and being stopped at any moment.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/runner/sensor_thread.h"

#include <gtest/gtest.h>

#include "tests/app/runner/simulated_scene.h"

namespace spool {
namespace {

using sensor::SourceEvent;
using std::chrono::milliseconds;
using test::ScriptedSource;
using test::Step;

constexpr milliseconds kLong{10000};

FramePtr tiny_frame(std::int64_t index) {
  auto frame = std::make_shared<DepthFrame>();
  const Camera camera = test::small_camera();
  frame->index = index;
  frame->width = camera.width;
  frame->height = camera.height;
  frame->depth.assign(std::size_t{160} * 120, static_cast<std::uint16_t>(1000 + index));
  return frame;
}

Step event_step(SourceEvent event) { return {{event, nullptr}, {}, {}}; }

std::vector<Step> frames_every(milliseconds delay, int count) {
  std::vector<Step> steps;
  for (int i = 0; i < count; ++i) {
    steps.push_back(test::frame_step(tiny_frame(i)));
    steps.back().delay = delay;
  }
  return steps;
}

struct Life {
  Mailbox<FramePtr> frames;
  CommandQueue<SensorNote> notes;
  sensor::FrameRing ring;
  std::unique_ptr<SensorThread> thread;
  Life(std::vector<Step> steps, bool recording)
      : thread(std::make_unique<SensorThread>(
            std::make_unique<ScriptedSource>(std::move(steps), recording), frames, notes, ring)) {}
};

TEST(SensorThread, HandsOnTheNewestFrameAndSaysWhenTheRecordingIsOver) {
  Life life(frames_every(milliseconds(0), 50), true);
  const auto note = life.notes.pop(kLong);
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kEnded);
  const auto frame = life.frames.try_take();
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ((*frame)->index, 49);
  EXPECT_EQ(life.ring.frames().size(), 50U) << "what vision did not take as well";
}

TEST(SensorThread, ReportsUnpluggingAndReplugging) {
  Life life({event_step(SourceEvent::kUnplugged), event_step(SourceEvent::kTimeout),
             event_step(SourceEvent::kReplugged), test::frame_step(tiny_frame(5))},
            false);
  const auto first = life.notes.pop(kLong);
  const auto second = life.notes.pop(kLong);
  ASSERT_TRUE(first.has_value() && second.has_value());
  EXPECT_EQ(first->kind, SensorNote::Kind::kUnplugged);
  EXPECT_EQ(second->kind, SensorNote::Kind::kReplugged);
  const auto frame = life.frames.take(kLong);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ((*frame)->index, 5);
}

TEST(SensorThread, PassesAFailureOnWithItsSentenceAndStops) {
  const Error error{ErrorCode::kNoDevice, "camera X does not answer; plug it in again"};
  Life life({{{}, {}, error}, test::frame_step(tiny_frame(1))}, false);
  const auto note = life.notes.pop(kLong);
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kFailed);
  EXPECT_EQ(note->error.message, error.message);
  life.thread.reset();
  EXPECT_EQ(life.frames.try_take(), std::nullopt);
}

TEST(SensorThread, SaysThatACameraRepeatsItselfAndHandsTheRepeatsOnToNobody) {
  std::vector<Step> steps{test::frame_step(tiny_frame(0))};
  for (int i = 0; i < 300; ++i) {
    steps.push_back(test::frame_step(tiny_frame(1)));
    steps.back().delay = milliseconds(5);
  }
  Life camera(steps, false);
  const auto note = camera.notes.pop(kLong);
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kTrouble);
  EXPECT_EQ(note->trouble, sensor::SensorTrouble::kStuck);
  EXPECT_FALSE(note->words.empty());
  ASSERT_TRUE(camera.frames.take(kLong).has_value());
  EXPECT_EQ(camera.frames.take(milliseconds(30)), std::nullopt);
}

TEST(SensorThread, ARecordingMayRepeatItself) {
  std::vector<Step> steps{test::frame_step(tiny_frame(0))};
  for (int i = 0; i < 250; ++i) {
    steps.push_back(test::frame_step(tiny_frame(1)));
    steps.back().delay = milliseconds(5);
  }
  Life recording(steps, true);
  const auto note = recording.notes.pop(kLong);
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kEnded);
}

TEST(SensorThread, EndsWhileItsCameraIsSilent) {
  Life life({}, false);
  life.thread.reset();  // must not hang
}

TEST(SensorThread, EndsWhileItsCameraIsSlow) {
  Life life(frames_every(milliseconds(20), 100), false);
  ASSERT_TRUE(life.frames.take(kLong).has_value());
  life.thread.reset();
}

TEST(SensorThread, ARecordingWaitsWhilePausedAndLosesNothing) {
  Life life(frames_every(milliseconds(30), 3), true);  // time to pause within the first
  life.thread->pause(true);
  // At most the frame that was being read when the pause began arrives.
  static_cast<void>(life.frames.take(milliseconds(80)));
  EXPECT_EQ(life.frames.take(milliseconds(80)), std::nullopt);
  EXPECT_FALSE(life.notes.try_pop().has_value());
  life.thread->pause(false);
  const auto note = life.notes.pop(kLong);
  ASSERT_TRUE(note.has_value());
  EXPECT_EQ(note->kind, SensorNote::Kind::kEnded);
  EXPECT_EQ((*life.frames.try_take())->index, 2);
}

TEST(SensorThread, ACameraGoesOnWhilePaused) {
  Life life(frames_every(milliseconds(2), 20), false);
  life.thread->pause(true);
  std::int64_t newest = -1;
  while (newest < 19) {
    const auto frame = life.frames.take(kLong);
    ASSERT_TRUE(frame.has_value());
    newest = (*frame)->index;
  }
}

}  // namespace
}  // namespace spool
