// Freeze: the picture, its pose and its numbers stand, the live ones go on underneath.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/application/bench.h"

namespace spool {
namespace {

// A camera that walks along, so that every picture is another.
std::vector<test::Step> walking(int frames) {
  std::vector<test::Step> steps;
  for (int i = 0; i < frames; ++i) {
    const Pose T = test::T_design_camera(0, 0.003 * std::max(0, i - 12));
    steps.push_back(test::frame_step(test::render_frame(*test::prepared_bracket(), T, i)));
  }
  return steps;
}

class Freeze : public test::Bench {
 protected:
  void align_and_freeze() {
    pick_three();
    press("Done");
    ASSERT_EQ(screen_["screen"], "work");
    ASSERT_FALSE(screen_.contains("frozen_frame"));
    press("Freeze");
    ASSERT_TRUE(screen_.contains("frozen_frame")) << screen_.dump();
  }
  [[nodiscard]] render::Image picture() const { return app_->picture().target().read(); }
};

TEST_F(Freeze, HoldsPictureAndNumbersWhileTheCameraIsFollowed) {
  start(walking(45));
  ASSERT_NO_FATAL_FAILURE(align_and_freeze());
  const auto frame = screen_["frozen_frame"];
  const render::Image first = picture();
  for (int i = 0; i < 12; ++i) step();
  EXPECT_TRUE(picture().rgba == first.rgba) << "to the last pixel";
  EXPECT_EQ(screen_["frozen_frame"], frame);
  EXPECT_FALSE(offers("Freeze"));
  EXPECT_TRUE(offers("Live"));
  press("Live");
  EXPECT_FALSE(screen_.contains("frozen_frame"));
  EXPECT_TRUE(offers("Freeze"));
  EXPECT_EQ(screen_["tracking"], "good") << "it was followed all the time";
  EXPECT_FALSE(picture().rgba == first.rgba);
  play_to_the_end();
  // No frame went by unfollowed.
  const std::string csv = app_->poses().text();
  for (int i = frame.get<int>(); i < 45; ++i)
    EXPECT_NE(csv.find("\n" + std::to_string(i) + ","), std::string::npos) << i;
}

TEST_F(Freeze, CheckAndShotTakeWhatIsFrozen) {
  start(walking(45));
  ASSERT_NO_FATAL_FAILURE(align_and_freeze());
  for (int i = 0; i < 10; ++i) step();
  press("Check");
  step();
  press("Shot");
  step();
  std::ifstream in(folder_.path() / "out" / "check_001" / "report.json");
  ASSERT_TRUE(in.good());
  nlohmann::json report;
  in >> report;
  EXPECT_EQ(report["scan"]["frame"], screen_["frozen_frame"]);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "screen_001.png"));
}

TEST_F(Freeze, StaysWithoutTheSensorAndGoesWithANewAlignment) {
  start(walking(45));
  ASSERT_NO_FATAL_FAILURE(align_and_freeze());
  notes_->push_back({SensorNote::Kind::kUnplugged});
  step();
  step();
  EXPECT_TRUE(offers("Check")) << "it is looked at as it was";
  EXPECT_FALSE(screen_.contains("still"));
  press("Align");
  EXPECT_FALSE(screen_.contains("frozen_frame"));
  press("Back");
  EXPECT_FALSE(offers("Check")) << "live again, and there is no sensor";
}

TEST_F(Freeze, IsNotOfferedWhereThereIsNothingToHold) {
  std::vector<test::Step> steps = walking(12);
  for (int i = 12; i < 20; ++i)
    steps.push_back(test::frame_step(test::empty_frame(test::T_design_camera(), i)));
  start(std::move(steps));
  pick_three();
  press("Done");
  play_to_the_end();
  step();
  EXPECT_EQ(screen_["tracking"], "lost");
  EXPECT_FALSE(offers("Freeze"));
}

}  // namespace
}  // namespace spool
