// The application by taps: through an alignment, checks, losses and full disks; numbers asserted.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "app/application/application.h"
#include "render/image.h"
#include "tests/app/application/bench.h"

namespace spool {
namespace {

using test::Bench;
using test::standing_still;

// How many different colours a picture holds: an empty or half-drawn one has few.
std::size_t colours(const render::Image& image) {
  std::set<std::uint32_t> seen;
  for (int y = 0; y < image.height; y += 2) {
    for (int x = 0; x < image.width; x += 2) {
      const std::uint8_t* p = image.pixel(x, y);
      seen.insert((std::uint32_t{p[0]} << 16U) | (std::uint32_t{p[1]} << 8U) | p[2]);
    }
  }
  return seen.size();
}

// The pose of a frame in poses.csv, where its quality is `quality`.
std::optional<Pose> pose_of(const std::string& csv, const std::string& frame,
                            const std::string& quality) {
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(frame + ",", 0) != 0) continue;
    const auto at = line.find("," + quality + ",");
    if (at == std::string::npos) return std::nullopt;
    line = line.substr(at + quality.size() + 2);
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    std::vector<double> numbers;
    for (double number = 0; in >> number;) numbers.push_back(number);
    return pose_from_row_major(numbers);
  }
  return std::nullopt;
}

TEST_F(Bench, ThreeTapsAlignTheDrawingWithinTheNoise) {
  start(standing_still(20));
  EXPECT_EQ(screen_["screen"], "align");
  EXPECT_FALSE(offers("Undo") || offers("Done") || offers("Back")) << "no dead buttons";
  pick_three();
  EXPECT_EQ(screen_["picks"], 3);
  press("Done");
  EXPECT_EQ(screen_["screen"], "work");
  EXPECT_EQ(screen_["tracking"], "good");
  play_to_the_end();

  // Thousands of points of 0.8 mm; the pixel grid at the edges leaves the rest.
  const auto T = pose_of(app_->poses().text(), "19", "good");
  ASSERT_TRUE(T.has_value()) << app_->poses().text();
  const PoseSize error = pose_size(test::T_design_camera().inverse() * *T);
  EXPECT_LT(error.translation_m, 0.0015);
  EXPECT_LT(error.rotation_rad, 0.004);

  ASSERT_TRUE(app_->finish().has_value());
  for (const char* file :
       {"screen_end.png", "report.json", "report.html", "points.ply", "overlay_1.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
  }
  const auto picture = render::read_png(folder_.path() / "out" / "screen_end.png");
  ASSERT_TRUE(picture.has_value());
  EXPECT_EQ(picture->width, 800);
  EXPECT_EQ(picture->height, 480);
  EXPECT_GT(colours(*picture), 200U);
}

TEST_F(Bench, ARecordingWaitsWhilePicksAreMadeAndUndoLetsItGoOn) {
  start(standing_still(30));
  const auto pairs = three();
  ASSERT_EQ(pairs.size(), 3U);
  tap_at(pairs[0].scan);  // paired with the proposed design point
  EXPECT_EQ(screen_["picks"], 1);
  EXPECT_TRUE(screen_.contains("held_frame"));
  for (int i = 0; i < 60; ++i) step();
  EXPECT_FALSE(app_->source_has_ended()) << "the recording waits for the fitter";
  press("Undo");
  EXPECT_EQ(screen_["picks"], 0);
  EXPECT_FALSE(screen_.contains("held_frame"));
  play_to_the_end();
  step();
  EXPECT_TRUE(offers("Replay"));
}

TEST_F(Bench, RefusesTheSamePointTwiceAndGoesOnAfterUndo) {
  start(standing_still(5));
  const auto pairs = three();
  ASSERT_EQ(pairs.size(), 3U);
  pick(pairs[0]);
  pick(pairs[1]);
  pick(pairs[1]);
  EXPECT_EQ(screen_["picks"], 3);
  EXPECT_FALSE(offers("Done"));
  press("Undo");
  pick(pairs[2]);
  EXPECT_TRUE(offers("Done"));
}

TEST_F(Bench, ATapBesideTheSteelPicksNothing) {
  start(standing_still(5), 480, 800);
  const auto rect = screen_["scan_view"]["rect"].get<std::vector<double>>();
  tap_at({rect[0] + 6, rect[1] + 0.5 * rect[3]});  // beside the letter-boxed picture
  EXPECT_EQ(screen_["picks"], 0);
  EXPECT_FALSE(screen_.contains("held_frame"));
}

TEST_F(Bench, ADragTurnsThePictureAndPicksNothing) {
  start(standing_still(5));
  const auto pairs = three();
  ASSERT_EQ(pairs.size(), 3U);
  const auto before = screen_["scan_view"]["T_view_world"];
  const test::Spot at = pairs[0].scan;
  step({{0, ui::TouchPhase::kDown, at.x, at.y, 0, 0},
        {0, ui::TouchPhase::kMove, at.x + 60, at.y, 0, 0},
        {0, ui::TouchPhase::kUp, at.x + 60, at.y, 0, 0}});
  step();
  step();
  EXPECT_NE(screen_["scan_view"]["T_view_world"], before);
  EXPECT_EQ(screen_["picks"], 0);
}

TEST_F(Bench, ShotAndCheckWriteWhatWasShown) {
  start(standing_still(20));
  pick_three();
  press("Done");
  press("Shot");
  press("Check");
  step();
  ASSERT_TRUE(app_->finish().has_value());
  const auto shot = render::read_png(folder_.path() / "out" / "screen_001.png");
  ASSERT_TRUE(shot.has_value());
  EXPECT_GT(colours(*shot), 200U);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "check_001" / "report.json"));
}

TEST_F(Bench, TheOverlayGoesWhenTheSpoolIsLost) {
  std::vector<test::Step> steps = standing_still(12);
  for (int i = 12; i < 20; ++i) {
    steps.push_back(test::frame_step(test::empty_frame(test::T_design_camera(), i)));
  }
  start(std::move(steps));
  pick_three();
  press("Done");
  EXPECT_TRUE(offers("Check"));
  play_to_the_end();
  step();
  EXPECT_EQ(screen_["tracking"], "lost");
  EXPECT_FALSE(offers("Check")) << "nothing to check";
  EXPECT_TRUE(offers("Align"));
  EXPECT_FALSE(pose_of(app_->poses().text(), "19", "good").has_value());
  EXPECT_TRUE(pose_of(app_->poses().text(), "19", "lost").has_value());
}

TEST_F(Bench, DrawsTheSamePictureTwice) {
  const auto run = [&] {
    start(standing_still(6));
    pick_three();
    press("Done");
    play_to_the_end();
    const render::Image image = app_->picture().target().read();
    app_.reset();
    return image.rgba;
  };
  const auto once = run();
  EXPECT_TRUE(once == run());
}

TEST_F(Bench, AFolderThatCannotBeWrittenIsSaid) {
  start(standing_still(6));
  std::ofstream(folder_.path() / "out") << "a file where the folder should be";
  pick_three();
  press("Done");
  press("Shot");
  const Status finished = app_->finish();
  ASSERT_FALSE(finished.has_value());
  EXPECT_EQ(finished.error().code, ErrorCode::kIo);
  EXPECT_NE(finished.error().message.find((folder_.path() / "out").string()), std::string::npos);
}

}  // namespace
}  // namespace spool
