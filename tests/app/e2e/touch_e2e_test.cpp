// The real window on a touch screen: fingers align, pinch and stray; every one an X event.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/image.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/sample_files.h"
#include "tests/app/e2e/touch_display.h"
#include "tests/app/e2e/window_session.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

using nlohmann::json;
using test::Spot;

class Touch : public testing::Test {
 protected:
  void SetUp() override {
    auto display = test::TouchDisplay::start(folder_.path());
    if (!display) SPOOL_SKIP_WITHOUT_DISPLAY(display.error().message);
    glass_ = std::move(*display);
    sample_ = test::read_sample();
    ASSERT_TRUE(sample_.prepared);
    session_.emplace(glass_->name(), std::vector<std::string>{"--design", sample_.design,
                                                              "--source", sample_.recording,
                                                              "--size", "1280x800", "--out", out_});
    ASSERT_TRUE(session_->until([](const json& s) {
      return s.contains("scan_view") && s["tracking"] != "none";
    })) << "no picture of the sensor";
  }

  // The picture is held by a first tap on the drawing; the camera moves until then.
  void hold(std::vector<test::SpotPair>& spots) {
    spots = three(0);
    ASSERT_EQ(spots.size(), 3U);
    ASSERT_TRUE(glass_->tap(spots[0].design));
    ASSERT_TRUE(session_->until([](const json& s) { return s.contains("held_frame"); }))
        << "the tap on the drawing held no picture";
    spots = three(session_->screen()["held_frame"].get<std::size_t>());
    ASSERT_EQ(spots.size(), 3U);
  }
  [[nodiscard]] std::vector<test::SpotPair> three(std::size_t frame) const {
    return test::choose_three(session_->screen(), *sample_.prepared, sample_.camera,
                              *sample_.frames.at(frame), sample_.T_design_camera.at(frame));
  }
  void pick(const test::SpotPair& pair, int number) {
    const std::string before = session_->screen()["lit"].dump();
    ASSERT_TRUE(glass_->tap(pair.design));
    ASSERT_TRUE(session_->until([&](const json& s) {
      return s.contains("lit") && s["lit"].dump() != before;
    })) << "the tap on the drawing lit nothing";
    ASSERT_TRUE(glass_->tap(pair.scan));
    ASSERT_TRUE(session_->until([&](const json& s) { return s["picks"] == number; }))
        << "pick " << number;
  }
  void press(const std::string& name) {
    ASSERT_TRUE(session_->until_offered(name)) << name;
    ASSERT_TRUE(glass_->tap(*test::target(session_->screen(), name)));
  }
  // Two fingers beside `middle`, from `from_px` to `to_px` apart by turns.
  void pinch(const Spot& middle, double from_px, double to_px) {
    const auto at = [&](int finger, double apart) {
      return Spot{middle.x + (finger == 0 ? -0.5 : 0.5) * apart, middle.y};
    };
    for (const int finger : {0, 1}) {
      ASSERT_TRUE(glass_->down(static_cast<std::uint32_t>(finger), at(finger, from_px)));
    }
    constexpr int kSteps = 10;
    for (int step = 1; step <= kSteps; ++step) {
      const double apart = from_px + (to_px - from_px) * step / kSteps;
      for (const int finger : {0, 1}) {
        ASSERT_TRUE(glass_->move(static_cast<std::uint32_t>(finger), at(finger, apart)));
      }
    }
    for (const int finger : {0, 1}) {
      ASSERT_TRUE(glass_->up(static_cast<std::uint32_t>(finger), at(finger, to_px)));
    }
  }

  test::TemporaryFolder folder_;
  const std::filesystem::path out_ = folder_.path() / "out";
  std::unique_ptr<test::TouchDisplay> glass_;  // goes after the program
  test::SampleFiles sample_;
  std::optional<test::WindowSession> session_;
};

TEST_F(Touch, AFingerTapsThroughAnAlignmentToASavedScreenshot) {
  std::vector<test::SpotPair> spots;
  ASSERT_NO_FATAL_FAILURE(hold(spots));
  // The design point that holds the picture is the first of another three.
  for (int i = 0; i < 3; ++i) {
    ASSERT_NO_FATAL_FAILURE(pick(spots[static_cast<std::size_t>((i + 1) % 3)], i + 1));
  }
  ASSERT_NO_FATAL_FAILURE(press("Done"));
  ASSERT_TRUE(session_->until([](const json& s) { return s["screen"] == "work"; }))
      << session_->screen().dump();
  EXPECT_NE(session_->screen()["tracking"], "lost");
  ASSERT_NO_FATAL_FAILURE(press("Shot"));
  ASSERT_TRUE(session_->until_written(out_ / "screen_001.png"));
  const auto shot = render::read_png(out_ / "screen_001.png");
  ASSERT_TRUE(shot.has_value());
  EXPECT_EQ(shot->width, test::TouchDisplay::kWidth);
  EXPECT_EQ(shot->height, test::TouchDisplay::kHeight);
  // Two fingers take the eye off the camera's place; a button brings it back.
  EXPECT_FALSE(test::target(session_->screen(), "Camera").has_value());
  ASSERT_NO_FATAL_FAILURE(pinch({500, 350}, 80, 160));
  ASSERT_NO_FATAL_FAILURE(press("Camera"));
  EXPECT_TRUE(session_->until([](const json& s) { return !test::target(s, "Camera"); }));
  EXPECT_EQ(session_->end(), 0);
  EXPECT_TRUE(std::filesystem::exists(out_ / "report.json"));
}

TEST_F(Touch, TwoFingersApartBringTheirMiddleCloser) {
  const auto before = session_->screen()["scan_view"];
  const auto rect = before["rect"].get<std::vector<double>>();
  const Spot middle{std::round(rect[0] + 0.4 * rect[2]), std::round(rect[1] + 0.6 * rect[3])};
  ASSERT_NO_FATAL_FAILURE(pinch(middle, 80, 160));
  // Twice as far apart: what was a metre ahead is half a metre ahead, and under the fingers still.
  const double x = (middle.x - rect[0] - before["cx"].get<double>()) / before["fx"].get<double>();
  const double y = (middle.y - rect[1] - before["cy"].get<double>()) / before["fy"].get<double>();
  std::array<double, 3> moved{};
  const auto is_closer = [&](const json& s) {
    const auto T = s["scan_view"]["T_view_world"].get<std::vector<double>>();
    moved = {T[3], T[7], T[11]};
    return std::abs(moved[2] + 0.5) < 1e-3;
  };
  ASSERT_TRUE(session_->until(is_closer)) << moved[2];
  // The fingers move by turns, by whole axis steps of the screen: 2 px at half a metre.
  const double slack = 0.5 * 2 / before["fx"].get<double>();
  EXPECT_NEAR(moved[0], -0.5 * x, slack);
  EXPECT_NEAR(moved[1], -0.5 * y, slack);
  EXPECT_EQ(session_->screen()["picks"], 0);
  EXPECT_FALSE(session_->screen().contains("held_frame")) << "a pinch is no tap";
  EXPECT_EQ(session_->end(), 0);
}

TEST_F(Touch, AStrayFingerDuringAPickDoesNothing) {
  std::vector<test::SpotPair> spots;
  ASSERT_NO_FATAL_FAILURE(hold(spots));
  const json before = session_->screen();
  const Spot shot = *test::target(before, "Shot");
  // A second finger on the picture, on the drawing and on a button while the first one picks.
  for (const Spot& stray : {spots[2].scan, spots[1].design, shot}) {
    EXPECT_TRUE(glass_->down(0, spots[0].scan));
    EXPECT_TRUE(glass_->down(1, stray));
    EXPECT_TRUE(glass_->up(1, stray));
    EXPECT_TRUE(glass_->up(0, spots[0].scan));
  }
  // What comes after it all counts as ever; had a stray finger counted, there were more picks.
  ASSERT_NO_FATAL_FAILURE(pick(spots[1], 1));
  EXPECT_EQ(session_->screen()["scan_view"], before["scan_view"]);
  EXPECT_EQ(session_->screen()["design_view"], before["design_view"]);
  // A thumb that holds the tablet by its strip keeps no finger from picking.
  EXPECT_TRUE(glass_->down(7, {300, 10}));
  ASSERT_NO_FATAL_FAILURE(pick(spots[2], 2));
  EXPECT_TRUE(glass_->up(7, {300, 10}));
  ASSERT_NO_FATAL_FAILURE(press("Shot"));
  ASSERT_TRUE(session_->until_written(out_ / "screen_001.png"));
  EXPECT_EQ(session_->end(), 0);
  EXPECT_FALSE(std::filesystem::exists(out_ / "screen_002.png")) << "the stray finger pressed Shot";
}

}  // namespace
}  // namespace spool
