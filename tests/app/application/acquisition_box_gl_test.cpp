// The acquisition box by taps: search and picks look inside it only.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/app/application/bench.h"

namespace spool {
namespace {

using Eigen::Vector3d;

class BoxBench : public test::Bench {
 protected:
  // A point of the design's frame in the camera picture.
  [[nodiscard]] test::Spot on_scan(const Vector3d& p_design) const {
    const auto spot =
        test::spot_in(screen_["scan_view"], test::T_design_camera().inverse() * p_design);
    EXPECT_TRUE(spot.has_value());
    return spot.value_or(test::Spot{});
  }
  void box(const Vector3d& from, const Vector3d& to) {
    press("Box");
    ASSERT_EQ(screen_["box"], "asking");
    tap_at(on_scan(from));
    EXPECT_TRUE(screen_.contains("held_frame")) << "both taps are made on one picture";
    ASSERT_EQ(screen_["box"], "asking");
    tap_at(on_scan(to));
    ASSERT_NE(screen_["box"], "asking") << screen_.dump();
  }
  [[nodiscard]] int percent() const { return std::stoi(screen_["box"].get<std::string>()); }
};

// A point of the floor, from the bracket's middle: to the right and away as the camera looks.
Vector3d on_floor(double right, double away) {
  const Vector3d a(-std::cos(-1.0), -std::sin(-1.0), 0), r(a.y(), -a.x(), 0);
  return Vector3d(0.2, 0.1, -0.1) + right * r + away * a;
}
const Vector3d kOnBase(0.35, 0.05, 0.05);  // of the bracket

TEST_F(BoxBench, AboutTheSpoolLeavesOutTheRestAndFindsIt) {
  start(test::standing_still(40));
  ASSERT_NO_FATAL_FAILURE(box(on_floor(-0.24, -0.21), on_floor(0.24, 0.21)));
  EXPECT_GT(percent(), 10);
  EXPECT_LT(percent(), 85);
  press("Find");
  step();
  EXPECT_EQ(screen_["screen"], "work") << screen_["hint"];
  EXPECT_FALSE(screen_.contains("box")) << "now it follows from the design";
}

TEST_F(BoxBench, BesideTheSpoolFindsNothingThoughTheSpoolIsInThePicture) {
  start(test::standing_still(40));
  ASSERT_NO_FATAL_FAILURE(box(on_floor(-0.42, -0.1), on_floor(-0.36, 0.1)));
  EXPECT_LT(percent(), 40);
  press("Find");
  step();
  EXPECT_EQ(screen_["screen"], "align");
  EXPECT_EQ(screen_["find"]["phase"], "not found");
  // Nor can the spool be picked.
  tap_at(on_scan(kOnBase));
  EXPECT_EQ(screen_["picks"], 0);
  const std::string hint = screen_["hint"];
  EXPECT_NE(hint.find("No depth there"), std::string::npos) << hint;
  // Without the box both work again.
  press("Box");
  EXPECT_FALSE(screen_.contains("box"));
  tap_at(on_scan(kOnBase));
  EXPECT_EQ(screen_["picks"], 1);
}

TEST_F(BoxBench, StandsInTheSceneWhileTheCameraWalks) {
  std::vector<test::Step> steps;
  for (int i = 0; i < 60; ++i) {
    const Pose T = test::T_design_camera(0.006 * std::max(0, i - 15));
    steps.push_back(test::frame_step(
        test::render_in_workshop(test::prepared_bracket().get(), Pose::Identity(), T, i)));
  }
  start(std::move(steps));
  ASSERT_NO_FATAL_FAILURE(box(on_floor(-0.24, -0.21), on_floor(0.24, 0.21)));
  const int before = percent();
  EXPECT_FALSE(screen_.contains("held_frame")) << "the picture goes on";
  play_to_the_end();
  step();
  EXPECT_NEAR(percent(), before, 10) << "0.27 rad further round the bracket";
}

TEST_F(BoxBench, CanBeLeftHalfWay) {
  start(test::standing_still(20));
  press("Box");
  tap_at(on_scan(kOnBase));
  press("Box");
  EXPECT_FALSE(screen_.contains("box"));
  EXPECT_FALSE(screen_.contains("held_frame"));
  EXPECT_EQ(screen_["picks"], 0);
  pick_three();
  press("Done");
  EXPECT_EQ(screen_["screen"], "work");
}

}  // namespace
}  // namespace spool
