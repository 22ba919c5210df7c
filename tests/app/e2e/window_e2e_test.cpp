// The real window, driven by taps through an alignment to a saved screenshot.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/image.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/bracket_files.h"
#include "tests/app/e2e/running_program.h"
#include "tests/app/e2e/window_session.h"
#include "tests/app/runner/simulated_scene.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

// A mouse on a display where the window stands in the corner: window px are display px.
void tap(const std::string& xdotool, const std::string& display, const test::Spot& spot) {
  static_cast<void>(test::run(xdotool,
                              {"mousemove", std::to_string(std::lround(spot.x)),
                               std::to_string(std::lround(spot.y)), "click", "1"},
                              {.environment = {{"DISPLAY", display}}}));
}

// A display of its own with a mouse; none where the tools are not installed.
struct MouseDisplay {
  std::string xdotool, name;
  std::unique_ptr<test::RunningProgram> server;
};
std::optional<MouseDisplay> start_display() {
  const auto xvfb = test::find_tool("Xvfb");
  const auto xdotool = test::find_tool("xdotool");
  if (!xvfb || !xdotool) return std::nullopt;
  // The server says on which free display it runs.
  auto server = std::make_unique<test::RunningProgram>(std::vector<std::string>{
      *xvfb, "-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"});
  const auto number = server->next_line(milliseconds(20000));
  EXPECT_TRUE(number.has_value()) << "Xvfb did not start";
  return MouseDisplay{*xdotool, ":" + number.value_or(""), std::move(server)};
}

bool shows_a_picture(const json& s) { return s.contains("scan_view") && s["tracking"] != "none"; }

TEST(Window, TapsThroughAThreePointAlignmentToASavedScreenshot) {
  const auto glass = start_display();
  if (!glass) SPOOL_SKIP_WITHOUT_DISPLAY("Xvfb or xdotool is not installed");
  const std::string& display = glass->name;
  const auto xdotool = std::optional(glass->xdotool);

  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 3);
  ASSERT_TRUE(files.prepared);
  const std::filesystem::path out = folder.path() / "out";
  test::WindowSession session(display, {"--design", files.design, "--design-unit", "m", "--source",
                                        files.recording, "--size", "800x600", "--out", out});
  const auto press = [&](const std::string& name) {
    const bool there = session.until_offered(name);
    if (there) tap(*xdotool, display, *test::target(session.screen(), name));
    return there;
  };
  ASSERT_TRUE(session.until(shows_a_picture)) << "no picture of the sensor";

  const Pose truth = test::T_design_camera();
  const auto frame = test::render_frame(*files.prepared, truth, 0);
  const auto spots =
      test::choose_three(session.screen(), *files.prepared, test::small_camera(), *frame, truth);
  ASSERT_EQ(spots.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string before = session.screen()["lit"].dump();
    tap(*xdotool, display, spots[i].design);
    ASSERT_TRUE(session.until([&](const json& s) {
      return s.contains("lit") && s["lit"].dump() != before;
    })) << "the tap on the drawing lit nothing";
    tap(*xdotool, display, spots[i].scan);
    ASSERT_TRUE(session.until([&](const json& s) { return s["picks"] == i + 1; }))
        << "pick " << i + 1;
  }
  ASSERT_TRUE(press("Done"));
  ASSERT_TRUE(session.until([](const json& s) { return s["screen"] == "work"; }))
      << session.screen().dump();
  EXPECT_NE(session.screen()["tracking"], "lost");
  ASSERT_TRUE(press("Shot"));
  ASSERT_TRUE(session.until_written(out / "screen_001.png"));
  const auto shot = render::read_png(out / "screen_001.png");
  ASSERT_TRUE(shot.has_value());
  EXPECT_EQ(shot->width, 800);
  EXPECT_EQ(shot->height, 600);
  EXPECT_EQ(session.end(), 0) << "SIGTERM is a clean end";
  EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
}

TEST(Window, OnePressOfFindAlignsAndClosingInTheMiddleOfASearchIsACleanEnd) {
  const auto glass = start_display();
  if (!glass) SPOOL_SKIP_WITHOUT_DISPLAY("Xvfb or xdotool is not installed");
  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 3);
  ASSERT_TRUE(files.prepared);
  for (const bool closes : {false, true}) {
    const std::filesystem::path out = folder.path() / (closes ? "closed" : "found");
    test::WindowSession session(
        glass->name, {"--design", files.design, "--design-unit", "m", "--source", files.recording,
                      "--size", "800x600", "--out", out});
    ASSERT_TRUE(session.until(shows_a_picture)) << "no picture of the sensor";
    ASSERT_TRUE(session.until_offered("Find"));
    tap(glass->xdotool, glass->name, *test::target(session.screen(), "Find"));
    ASSERT_TRUE(session.until([](const json& s) {
      return s["find"]["phase"] == "running" || s["screen"] == "work";
    })) << session.screen().dump();
    if (!closes) {
      ASSERT_TRUE(session.until([](const json& s) { return s["screen"] == "work"; }))
          << session.screen().dump();
      // Good or, of the few frames that are left of the recording, not yet.
      EXPECT_NE(session.screen()["tracking"], "lost") << session.screen().dump();
      EXPECT_NE(session.screen()["tracking"], "none") << session.screen().dump();
    }
    EXPECT_EQ(session.end(), 0);
    if (!closes) {
      EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
    }
  }
}

}  // namespace
}  // namespace spool
