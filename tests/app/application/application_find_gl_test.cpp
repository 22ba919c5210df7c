// Find in the application: one press instead of three taps, and every way out of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/application/bench.h"
#include "tests/support/cancelling.h"

namespace spool {
namespace {

using test::standing_still;
using Clock = std::chrono::steady_clock;

class FindBench : public test::Bench {
 protected:
  [[nodiscard]] std::string phase() const { return screen_["find"]["phase"]; }
  [[nodiscard]] std::string hint() const { return screen_["hint"]; }

  // A search that is still on: the screen does not wait for it here.
  void start_searching(std::vector<test::Step> steps) {
    wait_for_jobs_ = false;
    start(std::move(steps));
    find_ = *test::target(screen_, "Find");
    step(test::tap(find_));
    for (int i = 0; i < 5 && phase() != "running"; ++i) step();
    ASSERT_EQ(phase(), "running");
  }
  void wait_until_it_ends() {
    for (int i = 0; i < 3000 && phase() == "running"; ++i) {
      step();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_NE(phase(), "running");
  }
  void expect_tracked_to_the_truth() {
    EXPECT_EQ(screen_["screen"], "work");
    for (int i = 0; i < 8 && screen_["tracking"] != "good"; ++i) step();  // one frame says little
    EXPECT_EQ(screen_["tracking"], "good") << hint();
    EXPECT_FALSE(app_->poses().text().empty());
  }

  test::Spot find_;  // where the button was
};

std::vector<test::Step> empty_floor(int frames) {
  std::vector<test::Step> steps;
  for (int i = 0; i < frames; ++i)
    steps.push_back(test::frame_step(test::empty_frame(test::T_design_camera(), i)));
  return steps;
}

TEST_F(FindBench, OnePressAlignsAsThreeTapsDo) {
  start(standing_still(12));
  EXPECT_NE(hint().find("Press Find"), std::string::npos) << hint();
  press("Find");
  step();
  expect_tracked_to_the_truth();
  EXPECT_FALSE(screen_.contains("held_frame"));
  EXPECT_TRUE(offers("Check"));
  play_to_the_end();
  EXPECT_EQ(screen_["tracking"], "good") << "it is followed from there";
}

TEST_F(FindBench, NotFoundIsSaidWithWhatToDoAndTheCameraGoesOn) {
  start(empty_floor(12));
  press("Find");
  EXPECT_EQ(screen_["screen"], "align");
  EXPECT_EQ(phase(), "not found");
  EXPECT_NE(hint().find("; "), std::string::npos) << "what happened; what to do: " << hint();
  EXPECT_FALSE(screen_.contains("held_frame")) << "look from elsewhere";
  EXPECT_TRUE(offers("Find") && offers("Other")) << "both ways are open";
  play_to_the_end();
  EXPECT_EQ(screen_["tracking"], "lost");
}

TEST_F(FindBench, CancelIsObeyedAtOnceAndTheRecordingGoesOn) {
  start_searching(standing_still(8));
  step();
  EXPECT_TRUE(screen_.contains("held_frame"));
  EXPECT_TRUE(offers("Cancel"));
  EXPECT_FALSE(offers("Find") || offers("Done") || offers("Other")) << "no dead buttons";
  const auto cancel = *test::target(screen_, "Cancel");
  step({test::tap(cancel)[0]});
  EXPECT_EQ(phase(), "running");
  const auto asked = Clock::now();
  step({test::tap(cancel)[1]});
  EXPECT_EQ(phase(), "idle");
  EXPECT_FALSE(screen_.contains("held_frame"));
  // One frame of the screen, which a software renderer draws in less than that.
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - asked).count(), test::kObeyed_s);
  play_to_the_end();
  EXPECT_EQ(screen_["screen"], "align") << "its answer never comes";
  EXPECT_EQ(screen_["tracking"], "lost");
  EXPECT_TRUE(offers("Find"));
}

TEST_F(FindBench, APressWhereFindWasDoesNotStopIt) {
  start_searching(standing_still(8));
  step();  // a button that has just come is not pressed yet
  ASSERT_EQ(phase(), "running");
  step(test::tap(find_));
  step();
  wait_until_it_ends();
  for (int i = 0; i < 5; ++i) step();
  expect_tracked_to_the_truth();
}

TEST_F(FindBench, ATapOnThePictureStopsTheSearchAndPicks) {
  start_searching(standing_still(8));
  const auto pairs = three();
  ASSERT_EQ(pairs.size(), 3U);
  pick(pairs[0]);
  EXPECT_EQ(phase(), "idle");
  EXPECT_EQ(screen_["picks"], 1);
  EXPECT_TRUE(screen_.contains("held_frame")) << "of the picture that was tapped";
  pick(pairs[1]);
  pick(pairs[2]);
  press("Done");
  step();
  expect_tracked_to_the_truth();
}

TEST_F(FindBench, ATapThatMeetsNothingLetsThePictureGo) {
  start_searching(standing_still(8));
  const auto rect = screen_["scan_view"]["rect"].get<std::vector<double>>();
  tap_at({rect[0] + 0.5 * rect[2], rect[1] + 2});  // above the letter-boxed picture
  EXPECT_EQ(phase(), "idle");
  EXPECT_EQ(screen_["picks"], 0);
  EXPECT_FALSE(screen_.contains("held_frame"));
}

TEST_F(FindBench, ASensorThatGoesAwayEndsTheSearch) {
  for (const auto kind : {SensorNote::Kind::kUnplugged, SensorNote::Kind::kFailed}) {
    start_searching(standing_still(8));
    notes_->push_back({kind, {ErrorCode::kNoDevice, "the camera burns; put it out"}});
    step();
    EXPECT_EQ(phase(), "not found");
    EXPECT_FALSE(offers("Cancel"));
    EXPECT_FALSE(offers("Find")) << "there is nothing to look at";
    EXPECT_FALSE(screen_.contains("held_frame"));
    EXPECT_NE(hint().find(kind == SensorNote::Kind::kFailed ? "burns" : "unplugged"),
              std::string::npos)
        << hint();
    notes_->push_back({SensorNote::Kind::kReplugged, {}});
    step();
    step();  // the first picture since then
    if (kind == SensorNote::Kind::kUnplugged) {
      EXPECT_TRUE(offers("Find"));
      EXPECT_NE(hint().find("press Find"), std::string::npos) << hint();
    }
    app_.reset();
  }
}

TEST_F(FindBench, TheWindowClosesInTheMiddleOfASearch) {
  for (const bool finished : {true, false}) {
    start_searching(standing_still(8));
    const auto asked = Clock::now();
    if (finished) {
      EXPECT_TRUE(app_->finish().has_value());
    }
    const auto left = Clock::now();
    app_.reset();
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - left).count(), 0.5);
    EXPECT_LT(std::chrono::duration<double>(left - asked).count(), 5.0);
  }
}

TEST_F(FindBench, ALostSpoolIsFoundAgainByOnePress) {
  std::vector<test::Step> steps = standing_still(10);
  for (int i = 10; i < 14; ++i)
    steps.push_back(test::frame_step(test::empty_frame(test::T_design_camera(), i)));
  // From another side: nothing that is followed from frame to frame comes back there.
  for (int i = 14; i < 60; ++i)
    steps.push_back(test::frame_step(
        test::render_frame(*test::prepared_bracket(), test::T_design_camera(2.0), i)));
  start(std::move(steps));
  press("Find");
  expect_tracked_to_the_truth();
  for (int i = 0; i < 20 && screen_["tracking"] != "lost"; ++i) step();
  ASSERT_EQ(screen_["tracking"], "lost");
  for (int i = 0; i < 6; ++i) step();  // past the frames that show the floor alone
  press("Find");
  step();
  expect_tracked_to_the_truth();
}

// Turned on its rolls, carried off: no tap is asked for.
TEST_F(FindBench, ASpoolSetDownElsewhereIsAlignedAgainByItself) {
  const auto shop = [](const Pose& T_shop_design, int i) {
    return test::frame_step(test::render_in_workshop(test::prepared_bracket().get(), T_shop_design,
                                                     test::T_design_camera(), i));
  };
  Pose elsewhere(Eigen::AngleAxisd(1.3, Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d middle(0.2, 0.1, 0);
  elsewhere.translation() = middle - elsewhere.linear() * middle;
  std::vector<test::Step> steps;
  for (int i = 0; i < 20; ++i) steps.push_back(shop(Pose::Identity(), i));
  for (int i = 20; i < 70; ++i) steps.push_back(shop(elsewhere, i));
  start(std::move(steps));
  press("Find");
  expect_tracked_to_the_truth();
  bool was_lost = false;
  int back = 0;  // frames from there on
  for (int i = 0; i < 70 && !app_->source_has_ended(); ++i) {
    step();
    was_lost = was_lost || screen_["tracking"] == "lost";
    if (was_lost && screen_["tracking"] == "good" && back == 0) back = i;
  }
  EXPECT_TRUE(was_lost);
  EXPECT_EQ(screen_["screen"], "work");
  EXPECT_EQ(screen_["tracking"], "good") << hint();
  EXPECT_GT(back, 0);
  // The last row of the poses is where the camera really is to the bracket.
  std::string text = app_->poses().text();
  text.pop_back();
  const std::string row = text.substr(text.rfind('\n') + 1);
  std::vector<double> numbers;
  std::size_t at = row.find("good,");
  ASSERT_NE(at, std::string::npos) << row;
  at += 5;
  while (numbers.size() < 16) {
    numbers.push_back(std::stod(row.substr(at)));
    at = row.find(',', at) + 1;
  }
  const auto T = pose_from_row_major(numbers);
  ASSERT_TRUE(T.has_value());
  const PoseSize off = pose_size((elsewhere.inverse() * test::T_design_camera()).inverse() * *T);
  EXPECT_LT(off.translation_m, 0.003);
}

TEST_F(FindBench, AChoiceIsSteppedThroughAndTheAcceptedOneIsAligned) {
  design_ = test::prepared_plate();
  start(standing_still(12, *design_));
  press("Find");
  ASSERT_EQ(screen_["screen"], "choose") << screen_.dump();
  const int choices = screen_["find"]["choices"];
  ASSERT_GE(choices, 2);
  EXPECT_NE(hint().find(std::to_string(choices) + " ways"), std::string::npos) << hint();
  EXPECT_TRUE(offers("Accept") && offers("Next") && offers("Cancel"));
  const auto first = app_->picture().target().read();
  press("Next");
  EXPECT_EQ(screen_["find"]["choice"], 1);
  EXPECT_FALSE(app_->picture().target().read().rgba == first.rgba) << "the other one is shown";
  for (int i = 1; i < choices; ++i) press("Next");
  EXPECT_EQ(screen_["find"]["choice"], 0) << "round again";
  EXPECT_EQ(app_->poses().text().find("good"), std::string::npos) << "nothing is aligned yet";
  press("Accept");
  step();
  expect_tracked_to_the_truth();
  play_to_the_end();
  EXPECT_EQ(screen_["tracking"], "good") << hint();
}

TEST_F(FindBench, AChoiceThatNobodyMakesAlignsNothing) {
  design_ = test::prepared_plate();
  for (const bool cancels : {true, false}) {
    start(standing_still(12, *design_));
    press("Find");
    ASSERT_EQ(screen_["screen"], "choose");
    if (cancels) {
      press("Cancel");
    } else {
      app_->give_up_picks();
      step();
    }
    EXPECT_EQ(screen_["screen"], "align");
    EXPECT_FALSE(screen_.contains("held_frame"));
    play_to_the_end();
    EXPECT_EQ(screen_["tracking"], "lost");
    EXPECT_EQ(app_->poses().text().find("good"), std::string::npos);
    app_.reset();
  }
}

// Under 100 ms from finger to screen, on every shape of screen: buttons a thumb wide.
TEST_F(FindBench, EveryButtonOfFindIsAThumbWide) {
  for (const auto& [width, height] :
       {std::pair(800, 480), std::pair(1280, 800), std::pair(480, 800)}) {
    design_ = test::prepared_plate();
    start(standing_still(6, *design_), width, height);
    const auto check = [&](const std::string& name) {
      ASSERT_TRUE(offers(name)) << name;
      const auto rect = screen_["targets"][name].get<std::vector<double>>();
      EXPECT_GE(rect[2], 76) << name;
      EXPECT_GE(rect[3], 76) << name;
    };
    check("Find");
    press("Find");
    for (const char* name : {"Accept", "Next", "Cancel"}) check(name);
    app_.reset();
  }
}

}  // namespace
}  // namespace spool
