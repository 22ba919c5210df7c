// The application by taps: through an alignment, checks, losses and full disks; numbers asserted.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "app/application/application.h"
#include "render/image.h"
#include "render/image_compare.h"
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

// The mean colour of the square about (x, y) within the picture.
Eigen::Vector3d mean_about(const render::Image& image, double x, double y, int radius) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (int v = static_cast<int>(y) - radius; v <= static_cast<int>(y) + radius; ++v) {
    for (int u = static_cast<int>(x) - radius; u <= static_cast<int>(x) + radius; ++u) {
      if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
      const std::uint8_t* p = image.pixel(u, v);
      sum += Eigen::Vector3d(p[0], p[1], p[2]);
      ++count;
    }
  }
  return count > 0 ? Eigen::Vector3d(sum / count) : sum;
}

// How far a small picture is from a large one where both show the same camera's view (0 to 255);
// `covered` is where panels stand over the large one. Means of a neighbourhood: the points of the
// small picture have gaps.
double difference(const render::Image& small, const render::Image& large,
                  const std::vector<ui::Rect>& covered) {
  const auto camera = [](const render::Image& image) {
    return render::camera_in_picture(test::small_camera(), image.width, image.height);
  };
  const Camera from = camera(small), to = camera(large);
  constexpr int kRadius = 2;
  const int reach = static_cast<int>(std::lround(kRadius * to.fx / from.fx));
  double sum = 0;
  int count = 0;
  for (int y = 0; y < small.height; y += kRadius) {
    for (int x = 0; x < small.width; x += kRadius) {
      const double u = (x - from.cx) / from.fx * to.fx + to.cx;
      const double v = (y - from.cy) / from.fy * to.fy + to.cy;
      if (std::any_of(covered.begin(), covered.end(),
                      [&](const ui::Rect& rect) { return rect.contains(u, v); })) {
        continue;
      }
      sum += (mean_about(small, x, y, kRadius) - mean_about(large, u, v, reach)).cwiseAbs().mean();
      ++count;
    }
  }
  return sum / count;
}

render::Image cut(const render::Image& image, const nlohmann::json& rect) {
  render::Image out;
  const auto r = rect.get<std::vector<int>>();
  out.width = r[2];
  out.height = r[3];
  for (int y = 0; y < out.height; ++y) {
    const std::uint8_t* row = image.pixel(r[0], r[1] + y);
    out.rgba.insert(out.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(out.width));
  }
  return out;
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

TEST_F(Bench, ATapWithoutDepthIsRefusedAndAnotherPointIsOffered) {
  start(standing_still(5), 480, 800);
  const auto rect = screen_["scan_view"]["rect"].get<std::vector<double>>();
  const std::string first = screen_["lit"]["text"];
  tap_at({rect[0] + 6, rect[1] + 0.5 * rect[3]});
  const std::string hint = screen_["hint"];
  EXPECT_NE(hint.find("No depth there"), std::string::npos) << hint;
  EXPECT_EQ(screen_["lit"]["text"], first);
  const auto before = screen_["lit"]["position_m"];
  press("Other");
  EXPECT_NE(screen_["lit"]["position_m"], before);
  const std::string offered = screen_["lit"]["text"];
  EXPECT_NE(hint.find("Other point for " + offered), std::string::npos) << hint << offered;
  EXPECT_EQ(screen_["picks"], 0);
  EXPECT_EQ(std::string(screen_["hint"]).find("No depth"), std::string::npos);
  // Undo of the only pick lets the picture go on; the skipped point stays away.
  tap_at(three().at(0).scan);
  EXPECT_EQ(screen_["picks"], 1);
  press("Undo");
  EXPECT_FALSE(screen_.contains("held_frame"));
  EXPECT_NE(screen_["lit"]["position_m"], before);
  EXPECT_TRUE(offers("Other"));
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

TEST_F(Bench, TheLastGoodViewStaysAsAStillWhileTheSpoolIsLost) {
  // The camera moves aside, then sees the floor alone, then the spool again.
  constexpr int kLastGood = 25, kEmpty = 4, kAgain = 12;
  const auto walk = [](int frame) {
    return test::T_design_camera(0, 0.004 * std::clamp(frame - 5, 0, kLastGood - 5));
  };
  std::vector<test::Step> steps;
  for (int i = 0; i < kLastGood + kEmpty + kAgain; ++i) {
    const bool empty = i > kLastGood && i <= kLastGood + kEmpty;
    steps.push_back(
        test::frame_step(empty ? test::empty_frame(walk(i), i)
                               : test::render_frame(*test::prepared_bracket(), walk(i), i)));
  }
  start(std::move(steps));
  EXPECT_FALSE(screen_.contains("still"));
  pick_three();
  press("Done");
  ASSERT_EQ(screen_["tracking"], "good");
  const render::Image early = app_->picture().target().read();
  render::Image last;
  while (screen_["tracking"] != "lost" && !app_->source_has_ended()) {
    EXPECT_FALSE(screen_.contains("still")) << "the steel itself is to be seen";
    last = app_->picture().target().read();
    step();
  }
  ASSERT_EQ(screen_["tracking"], "lost");
  ASSERT_TRUE(screen_.contains("still")) << screen_.dump();
  EXPECT_EQ(screen_["still"]["frame"], kLastGood);
  const nlohmann::json place = screen_["still"]["rect"];
  const render::Image still = cut(app_->picture().target().read(), place);
  EXPECT_GT(colours(still), 100U) << "cloud and drawing, coloured";
  const ui::Layout layout = ui::lay_out(800, 480, 1);
  std::vector<ui::Rect> covered(std::begin(layout.actions), std::end(layout.actions));
  covered.insert(covered.end(), {layout.strip, layout.card, {0, 0, 160, 480}});
  // The small picture's lines and points are coarser: alike, not equal.
  const double to_last = difference(still, last, covered);
  const double to_early = difference(still, early, covered);
  EXPECT_LT(to_last, 0.5 * to_early) << to_last << " " << to_early;
  step();
  const auto again = cut(app_->picture().target().read(), place);
  EXPECT_TRUE(again.rgba == still.rgba) << "it stands still";
  play_to_the_end();
  step();
  EXPECT_EQ(screen_["tracking"], "good") << "found again from where it was last seen";
  EXPECT_FALSE(screen_.contains("still"));
  // A still without its frame and words would differ by 3.
  EXPECT_GT(difference(still, cut(app_->picture().target().read(), place), {}), 5.0) << "gone";
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

TEST_F(Bench, AGraphicsCardColoursAsVisionMeasures) {
  const auto run = [&](bool card) {
    has_graphics_card_ = card;
    start(standing_still(6));
    pick_three();
    press("Done");
    play_to_the_end();
    EXPECT_EQ(screen_["tracking"], "good");
    render::Image image = app_->picture().target().read();
    app_.reset();
    return image;
  };
  const render::Image by_vision = run(false);
  const render::Image by_card = run(true);
  EXPECT_FALSE(by_card.rgba == by_vision.rgba) << "another way was taken";
  // Here vision looks at every pixel too. Distances are off by up to 0.3 mm, which is 8 of 255, and
  // points at edges may be of either face.
  const auto compared = render::compare_images(
      by_card, by_vision, {.max_abs_diff = 12, .max_fraction = 0.005, .max_mean = 0.5});
  EXPECT_TRUE(compared.passed) << compared.summary();
}

TEST_F(Bench, EndsWhileDistancesAreMade) {
  wait_for_jobs_ = false;
  has_graphics_card_ = true;
  start(standing_still(2));
  const auto before = std::chrono::steady_clock::now();
  app_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
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
