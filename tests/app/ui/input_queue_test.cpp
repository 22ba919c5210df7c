// Claims about input cut into frames and the pointer that follows it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/input_queue.h"

#include <gtest/gtest.h>

namespace spool::ui {
namespace {

TouchEvent event(TouchPhase phase, double x, int id = 0) { return {id, phase, x, 0, 0, 0}; }

TEST(InputQueue, NeverGivesPressAndReleaseToOneFrame) {
  InputQueue queue;
  queue.push(event(TouchPhase::kDown, 1));
  queue.push(event(TouchPhase::kMove, 2));
  queue.push(event(TouchPhase::kMove, 3));
  queue.push(event(TouchPhase::kUp, 4));
  EXPECT_EQ(queue.take_frame().size(), 1U);
  EXPECT_EQ(queue.take_frame().size(), 3U);
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.take_frame().empty());
}

TEST(Pointer, IsPressedForAtLeastOneFrameOfATap) {
  Pointer pointer;
  follow(pointer, {event(TouchPhase::kDown, 5)});
  EXPECT_TRUE(pointer.known && pointer.pressed);
  follow(pointer, {event(TouchPhase::kUp, 5)});
  EXPECT_TRUE(pointer.known) << "the release is seen where the press was";
  EXPECT_FALSE(pointer.pressed);
  follow(pointer, {});
  EXPECT_FALSE(pointer.known) << "a lifted finger hovers over nothing";
}

TEST(Pointer, AMouseStaysWhereItIs) {
  Pointer pointer;
  follow(pointer, {event(TouchPhase::kDown, 5, kLeftButton)});
  follow(pointer, {event(TouchPhase::kUp, 6, kLeftButton)});
  follow(pointer, {});
  EXPECT_TRUE(pointer.known);
  EXPECT_EQ(pointer.x, 6);
}

TEST(Pointer, ASecondFingerTakesThePressAway) {
  Pointer pointer;
  follow(pointer, {event(TouchPhase::kDown, 5, 0)});
  follow(pointer, {event(TouchPhase::kDown, 90, 1)});
  EXPECT_FALSE(pointer.pressed);
  follow(pointer, {event(TouchPhase::kUp, 5, 0)});
  EXPECT_FALSE(pointer.known);
}

TEST(Pointer, IgnoresTheSecondFingerAndTheRightButton) {
  Pointer pointer;
  follow(pointer, {event(TouchPhase::kDown, 5, kRightButton)});
  EXPECT_FALSE(pointer.pressed);
  follow(pointer, {event(TouchPhase::kMove, 50, 4)});
  EXPECT_FALSE(pointer.known);
}

}  // namespace
}  // namespace spool::ui
