// The real window, driven by taps through an alignment to a saved screenshot.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/image.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/bracket_files.h"
#include "tests/app/e2e/running_program.h"
#include "tests/app/runner/simulated_scene.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;

// A software renderer on a busy machine draws a few frames a second.
constexpr seconds kPatience{90};

class Session {
 public:
  Session(const std::string& display, std::string xdotool, std::vector<std::string> words)
      : display_(display), xdotool_(std::move(xdotool)), app_(words, {{"DISPLAY", display}}) {}

  // Reads what the screen says until `wanted` holds.
  [[nodiscard]] bool until(const std::function<bool(const json&)>& wanted) {
    if (!screen_.is_null() && wanted(screen_)) return true;
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      const auto line = app_.next_line(milliseconds(500));
      if (!line) continue;
      screen_ = json::parse(*line, nullptr, false);
      if (!screen_.is_discarded() && wanted(screen_)) return true;
    }
    return false;
  }
  // The window fills the display from its corner: window px are display px.
  void tap(const test::Spot& spot) const {
    static_cast<void>(test::run(xdotool_,
                                {"mousemove", std::to_string(std::lround(spot.x)),
                                 std::to_string(std::lround(spot.y)), "click", "1"},
                                {.environment = {{"DISPLAY", display_}}}));
  }
  [[nodiscard]] bool press(const std::string& name) {
    const bool there = until([&](const json& s) { return test::target(s, name).has_value(); });
    if (there) tap(*test::target(screen_, name));
    return there;
  }
  [[nodiscard]] const json& screen() const { return screen_; }
  [[nodiscard]] int end() {
    app_.terminate();
    return app_.wait_for_end(kPatience);
  }

 private:
  std::string display_, xdotool_;
  test::RunningProgram app_;
  json screen_;
};

TEST(Window, TapsThroughAThreePointAlignmentToASavedScreenshot) {
  const auto xvfb = test::find_tool("Xvfb");
  const auto xdotool = test::find_tool("xdotool");
  if (!xvfb || !xdotool) GTEST_SKIP() << "Xvfb or xdotool is not installed";
  // The server says on which free display it runs.
  test::RunningProgram server(
      {*xvfb, "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"});
  const auto number = server.next_line(milliseconds(20000));
  ASSERT_TRUE(number.has_value()) << "Xvfb did not start";

  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 3);
  ASSERT_TRUE(files.prepared);
  const std::filesystem::path out = folder.path() / "out";
  Session session(
      ":" + *number, *xdotool,
      {test::program("spoolsight").string(), "--design", files.design, "--design-unit", "m",
       "--source", files.recording, "--size", "800x600", "--out", out, "--print-targets"});
  ASSERT_TRUE(session.until([](const json& s) {
    return s.contains("scan_view") && s["tracking"] != "none";
  })) << "no picture of the sensor";

  const Pose truth = test::T_design_camera();
  const auto frame = test::render_frame(*files.prepared, truth, 0);
  const auto spots =
      test::choose_three(session.screen(), *files.prepared, test::small_camera(), *frame, truth);
  ASSERT_EQ(spots.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string before = session.screen()["lit"].dump();
    session.tap(spots[i].design);
    ASSERT_TRUE(session.until([&](const json& s) {
      return s.contains("lit") && s["lit"].dump() != before;
    })) << "the tap on the drawing lit nothing";
    session.tap(spots[i].scan);
    ASSERT_TRUE(session.until([&](const json& s) { return s["picks"] == i + 1; }))
        << "pick " << i + 1;
  }
  ASSERT_TRUE(session.press("Done"));
  ASSERT_TRUE(session.until([](const json& s) { return s["screen"] == "work"; }))
      << session.screen().dump();
  EXPECT_NE(session.screen()["tracking"], "lost");
  ASSERT_TRUE(session.press("Shot"));
  for (int i = 0; i < 300 && !std::filesystem::exists(out / "screen_001.png"); ++i) {
    std::this_thread::sleep_for(milliseconds(100));
  }
  const auto shot = render::read_png(out / "screen_001.png");
  ASSERT_TRUE(shot.has_value());
  EXPECT_EQ(shot->width, 800);
  EXPECT_EQ(shot->height, 600);
  EXPECT_EQ(session.end(), 0) << "SIGTERM is a clean end";
  EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
}

}  // namespace
}  // namespace spool
