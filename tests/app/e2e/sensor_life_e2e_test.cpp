// The real program on the simulated camera, through OpenNI2: unplugged and plugged in again in the
// middle of the work.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <fstream>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/egl_context.h"
#include "tests/app/e2e/running_program.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace spool {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

// The camera's clock starts with its stream; the work has to be under way when it goes.
constexpr double kUnplugAt = 30, kUnplugFor = 3;  // s
constexpr std::chrono::seconds kPatience{120};

// The sample's scene with fewer pixels, so that a busy machine keeps up, and the plug pulled once.
std::filesystem::path write_scene(const std::filesystem::path& folder) {
  const std::filesystem::path sample = test::source_dir() / "assets" / "sample";
  json scene;
  std::ifstream(sample / "scene.json") >> scene;
  scene["design"] = (sample / "spool.glb").string();
  scene["sensor"]["width"] = 320;
  scene["sensor"]["height"] = 240;
  scene["unplug"] = json::array();
  scene["unplug"].push_back({{"at_s", kUnplugAt}, {"for_s", kUnplugFor}});
  std::ofstream(folder / "scene.json") << scene.dump();
  return folder / "scene.json";
}

// Find at several times: a press while the search runs begins it anew, one after it checks.
std::filesystem::path write_presses(const std::filesystem::path& folder) {
  json find;
  std::ifstream(test::source_dir() / "assets" / "sample" / "find.json") >> find;
  json script{{"events", json::array()}};
  for (const double t_s : {2.0, 12.0, 3600.0}) {  // the last keeps the program waiting
    for (json event : find["events"]) {
      event["t_s"] = t_s;
      script["events"].push_back(event);
    }
  }
  std::ofstream(folder / "presses.json") << script.dump();
  return folder / "presses.json";
}

struct Session {
  test::RunningProgram program;
  json screen = {};

  bool until(const std::function<bool(const json&)>& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      if (screen.is_object() && wanted(screen)) return true;
      if (const auto line = program.next_line(milliseconds(500)))
        screen = json::parse(*line, nullptr, false);
    }
    return false;
  }
};

bool is_followed(const json& screen) {
  return screen["screen"] == "work" && screen["tracking"] == "good";
}

TEST(SensorLife, UnpluggedInTheMiddleOfTheWorkItGoesOnWhereItWas) {
  if (std::getenv("SPOOL_REQUIRE_GL") == nullptr && !render::EglContext::surfaceless())
    GTEST_SKIP() << "no driver gives an OpenGL ES 3.0 context";
  const test::TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out", track = folder.path() / "poses.csv";
  Session session{
      test::RunningProgram({test::program("spoolsight").string(), "--design",
                            (test::source_dir() / "assets" / "sample" / "spool.glb").string(),
                            "--source", "simulated:" + write_scene(folder.path()).string(),
                            "--headless", "--script", write_presses(folder.path()).string(),
                            "--print-targets", "--track", track.string(), "--out", out.string()})};
  ASSERT_TRUE(session.until(is_followed)) << session.screen.dump();
  ASSERT_TRUE(session.until([](const json& screen) {
    return screen["hint"].get<std::string>().find("unplugged") != std::string::npos;
  })) << session.screen.dump();
  EXPECT_EQ(session.screen["tracking"], "lost") << "no overlay without a camera";
  EXPECT_EQ(session.screen["screen"], "work");
  ASSERT_TRUE(session.until(is_followed)) << session.screen.dump();
  EXPECT_EQ(session.screen["hint"].get<std::string>().find("unplugged"), std::string::npos);
  session.program.terminate();
  EXPECT_EQ(session.program.wait_for_end(kPatience), 0);
  EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
  // Frames go on from where they were, in number and time.
  std::ifstream rows(track);
  std::string line;
  std::getline(rows, line);
  double frame = -1, seconds = -1;
  int good = 0;
  std::string last;
  while (std::getline(rows, line)) {
    last = line;
    double next_frame = 0, next_seconds = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf", &next_frame, &next_seconds), 2);
    EXPECT_GT(next_frame, frame);
    EXPECT_GT(next_seconds, seconds);
    frame = next_frame;
    seconds = next_seconds;
    good += line.find(",good,") != std::string::npos && seconds > kUnplugAt ? 1 : 0;
  }
  EXPECT_GT(good, 0) << "the same alignment, after the plug was back; the last row: " << last;
}

}  // namespace
}  // namespace spool
