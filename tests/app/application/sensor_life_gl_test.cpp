// What the screen makes of a sensor that is unplugged, stuck or blinded, and of its last seconds.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "render/image.h"
#include "tests/app/application/bench.h"

namespace spool {
namespace {

using test::standing_still;

class SensorLife : public test::Bench {
 protected:
  [[nodiscard]] std::string hint() const { return screen_["hint"]; }
  void align() {
    pick_three();
    press("Done");
    ASSERT_EQ(screen_["screen"], "work");
  }
  void tell(SensorNote::Kind kind, sensor::SensorTrouble trouble = sensor::SensorTrouble::kNone,
            const std::string& words = {}) {
    notes_->push_back({kind, {}, trouble, words});
    step();
    step();
  }
};

TEST_F(SensorLife, WithoutPicturesTheOverlayGoesAndComesBackWithThem) {
  struct Case {
    const char* name;
    SensorNote::Kind kind;
    sensor::SensorTrouble trouble;
    std::string words;
    SensorNote::Kind over;
  };
  using Kind = SensorNote::Kind;
  for (const Case& each : {Case{"unplugged", Kind::kUnplugged, {}, "unplugged", Kind::kReplugged},
                           Case{"stuck", Kind::kTrouble, sensor::SensorTrouble::kStuck,
                                "It repeats itself.", Kind::kTrouble},
                           Case{"silent", Kind::kTrouble, sensor::SensorTrouble::kSilent,
                                "No picture comes.", Kind::kTrouble},
                           Case{"wrong mode", Kind::kTrouble, sensor::SensorTrouble::kWrongMode,
                                "It gives 320x240.", Kind::kTrouble}}) {
    SCOPED_TRACE(each.name);
    start(standing_still(40));
    ASSERT_NO_FATAL_FAILURE(align());
    EXPECT_TRUE(offers("Check"));
    tell(each.kind, each.trouble, each.words);
    EXPECT_NE(hint().find(each.words), std::string::npos) << hint();
    EXPECT_EQ(screen_["tracking"], "lost") << "nobody knows where the camera is by now";
    EXPECT_FALSE(offers("Check") || offers("Freeze") || offers("Find"));
    EXPECT_TRUE(screen_.contains("still"));
    tell(each.over);
    EXPECT_EQ(hint().find(each.words), std::string::npos) << hint();
    EXPECT_NE(screen_["tracking"], "lost");
    EXPECT_TRUE(offers("Check"));
    EXPECT_EQ(screen_["screen"], "work") << "in the same scene, with the same alignment";
    app_.reset();
  }
}

TEST_F(SensorLife, ACoveredLensIsSaidWhileVisionGoesOn) {
  start(standing_still(30));
  ASSERT_NO_FATAL_FAILURE(align());
  tell(SensorNote::Kind::kTrouble, sensor::SensorTrouble::kCovered, "Uncover the lens.");
  EXPECT_EQ(hint(), "Uncover the lens.");
  EXPECT_NE(screen_["tracking"], "lost") << "what is lost is said by vision";
}

TEST_F(SensorLife, AnArcLeavesTheLastGoodPictureAndSaysPaused) {
  constexpr int kArc = 30, kAfter = 36;
  std::vector<test::Step> steps = standing_still(50);
  for (int i = kArc; i < kAfter; ++i) {
    auto blind = std::make_shared<DepthFrame>(*steps[static_cast<std::size_t>(i)].output.frame);
    for (std::size_t p = 0; p < blind->depth.size(); ++p)
      if (p % 40 != 0) blind->depth[p] = 0;
    steps[static_cast<std::size_t>(i)] = test::frame_step(blind);
  }
  start(std::move(steps));
  ASSERT_NO_FATAL_FAILURE(align());
  while (hint().find("Paused") == std::string::npos && !app_->source_has_ended()) step();
  ASSERT_FALSE(app_->source_has_ended());
  EXPECT_EQ(screen_["tracking"], "poor");
  EXPECT_TRUE(offers("Check")) << "of the picture that is shown";
  EXPECT_FALSE(screen_.contains("still"));
  const render::Image first = app_->picture().target().read();
  step();
  EXPECT_TRUE(app_->picture().target().read().rgba == first.rgba) << "it stands still";
  for (int i = 0; i < 8; ++i) step();
  EXPECT_EQ(hint().find("Paused"), std::string::npos) << hint();
  EXPECT_EQ(screen_["tracking"], "good") << "at once afterwards";
  const std::string csv = app_->poses().text();
  for (int i = kArc; i < kAfter; ++i)
    EXPECT_NE(csv.find("\n" + std::to_string(i) + ","), std::string::npos) << i;
  EXPECT_EQ(csv.find(",lost,", csv.find("\n" + std::to_string(kArc) + ",")), std::string::npos);
}

TEST_F(SensorLife, TheLastSecondsAreSavedAsADepthFolderWithItsPoses) {
  start(standing_still(25));
  ASSERT_NO_FATAL_FAILURE(align());
  for (int i = 0; i < 5; ++i) step();
  EXPECT_FALSE(offers("Save"));
  press("More");
  press("Save");
  EXPECT_FALSE(offers("Save")) << "the menu is gone";
  const std::filesystem::path folder = folder_.path() / "out" / "last_001";
  const auto source = sensor::open_source(folder.string());
  ASSERT_TRUE(source.has_value()) << source.error().message;
  std::size_t frames = 0;
  for (;; ++frames) {
    const auto next = (*source)->next(std::chrono::milliseconds(100));
    ASSERT_TRUE(next.has_value());
    if (!next->frame) break;
    const auto given =
        test::render_frame(*design_, test::T_design_camera(), static_cast<std::int64_t>(frames));
    EXPECT_EQ(next->frame->depth, given->depth) << frames;
  }
  EXPECT_GT(frames, 10U);
  std::ifstream poses(folder / "poses.csv");
  std::stringstream text;
  text << poses.rdbuf();
  EXPECT_NE(text.str().find("\n9,"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find(",good,"), std::string::npos) << text.str();
  press("More");
  press("Save");
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "last_002" / "camera.json"));
  EXPECT_TRUE(app_->finish().has_value());
}

TEST_F(SensorLife, TheLastSecondsCanBeSavedBeforeAnAlignmentToo) {
  start(standing_still(25));  // it goes on meanwhile
  for (int i = 0; i < 3; ++i) step();
  press("More");
  press("Save");
  step();
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "last_001" / "poses.csv"))
      << screen_.dump();
}

TEST_F(SensorLife, WhatCannotBeSavedIsSaidAndLeavesNothing) {
  start(standing_still(8));
  std::ofstream(folder_.path() / "out") << "a file where the folder should be";
  press("More");
  press("Save");
  const Status finished = app_->finish();
  ASSERT_FALSE(finished.has_value());
  EXPECT_EQ(finished.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace spool
