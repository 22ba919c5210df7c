// What fingers mean, as a table: events in, gestures out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ui/gestures.h"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace spool::ui {
namespace {

constexpr double kSlop = 9;  // px: 1.5 mm at 160 dots an inch

TouchEvent down(int id, double x, double y) { return {id, TouchPhase::kDown, x, y, 0, 0}; }
TouchEvent move(int id, double x, double y) { return {id, TouchPhase::kMove, x, y, 0, 0}; }
TouchEvent up(int id, double x, double y) { return {id, TouchPhase::kUp, x, y, 0, 0}; }
TouchEvent wheel(double steps) { return {kLeftButton, TouchPhase::kWheel, 50, 60, 0, steps}; }

// All gestures of a row added up.
struct Sum {
  int taps = 0, orbits = 0, moves = 0;
  double dx = 0, dy = 0, factor = 1, roll = 0;
};

Sum sum_of(const std::vector<TouchEvent>& events, bool one_by_one) {
  GestureRecogniser recogniser(kSlop);
  Sum sum;
  const auto add = [&](const std::vector<Gesture>& gestures) {
    for (const Gesture& gesture : gestures) {
      sum.taps += gesture.kind == Gesture::Kind::kTap;
      sum.orbits += gesture.kind == Gesture::Kind::kOrbit;
      sum.moves += gesture.kind == Gesture::Kind::kMove;
      sum.dx += gesture.dx;
      sum.dy += gesture.dy;
      sum.factor *= gesture.factor;
      sum.roll += gesture.roll_rad;
    }
  };
  if (!one_by_one) {
    add(recogniser.feed(events));
  } else {
    for (const TouchEvent& event : events) add(recogniser.feed({event}));
  }
  return sum;
}

struct Row {
  std::string name;
  std::vector<TouchEvent> events;
  int taps;
  bool orbits, moves;
  double dx, dy, factor, roll;
};

const std::vector<Row>& rows() {
  const double right_angle = 0.5 * std::numbers::pi;
  static const std::vector<Row> table{
      {"a tap", {down(0, 10, 10), up(0, 10, 10)}, 1, false, false, 0, 0, 1, 0},
      {"a tap of a shaking finger",
       {down(0, 10, 10), move(0, 15, 14), up(0, 12, 10)},
       1,
       false,
       false,
       0,
       0,
       1,
       0},
      {"two taps",
       {down(0, 1, 1), up(0, 1, 1), down(0, 90, 1), up(0, 90, 1)},
       2,
       false,
       false,
       0,
       0,
       1,
       0},
      {"a drag",
       {down(0, 10, 10), move(0, 30, 10), move(0, 50, 40), up(0, 50, 40)},
       0,
       true,
       false,
       40,
       30,
       1,
       0},
      {"a drag and back is no tap",
       {down(0, 10, 10), move(0, 40, 10), up(0, 10, 10)},
       0,
       true,
       false,
       0,
       0,
       1,
       0},
      {"a right drag pans",
       {down(kRightButton, 0, 0), move(kRightButton, 5, 2), up(kRightButton, 5, 2)},
       0,
       false,
       true,
       5,
       2,
       1,
       0},
      {"a pinch to twice",
       {down(0, 100, 0), down(1, 200, 0), move(1, 300, 0), up(0, 100, 0), up(1, 300, 0)},
       0,
       false,
       true,
       50,
       0,
       2,
       0},
      {"two fingers pan",
       {down(0, 0, 0), down(1, 100, 0), move(0, 0, 20), move(1, 100, 20), up(1, 100, 20),
        up(0, 0, 20)},
       0,
       false,
       true,
       0,
       20,
       1,
       0},
      {"two fingers roll",
       {down(0, 0, 0), down(1, 100, 0), move(1, 0, 100), up(1, 0, 100), up(0, 0, 0)},
       0,
       false,
       true,
       -50,
       50,
       1,
       right_angle},
      {"a second finger that only touches is no tap",
       {down(0, 0, 0), down(1, 100, 0), up(1, 100, 0), up(0, 0, 0)},
       0,
       false,
       false,
       0,
       0,
       1,
       0},
      {"after a pinch the finger that stays may shake",
       {down(0, 0, 0), down(1, 100, 0), move(1, 200, 0), up(1, 200, 0), move(0, 4, 3), up(0, 5, 5)},
       0,
       false,
       true,
       50,
       0,
       2,
       0},
      {"after a pinch the finger that stays may go on",
       {down(0, 0, 0), down(1, 100, 0), up(1, 100, 0), move(0, 20, 0), move(0, 30, 0),
        up(0, 30, 0)},
       0,
       true,
       false,
       30,
       0,
       1,
       0},
      {"a finger taken away by the system",
       {down(0, 5, 5), {0, TouchPhase::kCancel, 5, 5, 0, 0}, up(0, 5, 5)},
       0,
       false,
       false,
       0,
       0,
       1,
       0},
      {"a finger that came down elsewhere",
       {move(3, 5, 5), up(3, 90, 5)},
       0,
       false,
       false,
       0,
       0,
       1,
       0},
      {"a wheel step there and back", {wheel(1), wheel(-1)}, 0, false, true, 0, 0, 1, 0},
  };
  return table;
}

TEST(Gestures, MeanWhatTheTableSaysHoweverTheyAreCutIntoFrames) {
  for (const Row& row : rows()) {
    for (const bool one_by_one : {false, true}) {
      SCOPED_TRACE(row.name + (one_by_one ? ", one event a frame" : ", all in one frame"));
      const Sum sum = sum_of(row.events, one_by_one);
      EXPECT_EQ(sum.taps, row.taps);
      EXPECT_EQ(sum.orbits > 0, row.orbits);
      EXPECT_EQ(sum.moves > 0, row.moves);
      EXPECT_NEAR(sum.dx, row.dx, 1e-9);
      EXPECT_NEAR(sum.dy, row.dy, 1e-9);
      EXPECT_NEAR(sum.factor, row.factor, 1e-9);
      EXPECT_NEAR(sum.roll, row.roll, 0.01);  // the way there goes through a chord
    }
  }
}

TEST(Gestures, ATapIsWhereTheFingerCameDown) {
  GestureRecogniser recogniser(kSlop);
  const auto gestures = recogniser.feed({down(0, 40, 50), move(0, 44, 55), up(0, 45, 56)});
  ASSERT_EQ(gestures.size(), 1U);
  EXPECT_EQ(gestures[0].x, 40);
  EXPECT_EQ(gestures[0].y, 50);
}

TEST(Gestures, ZoomIsAboutTheMiddleOfTheFingers) {
  GestureRecogniser recogniser(kSlop);
  const auto gestures = recogniser.feed({down(0, 100, 10), down(1, 200, 10), move(1, 300, 30)});
  ASSERT_EQ(gestures.size(), 1U);
  EXPECT_EQ(gestures[0].x, 200);
  EXPECT_EQ(gestures[0].y, 20);
  EXPECT_EQ(gestures[0].start_x, 100);
}

}  // namespace
}  // namespace spool::ui
