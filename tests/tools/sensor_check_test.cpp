// spoolsight-inspect --sensor-check on walls written by hand: what it finds, hands out and refuses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "tests/support/depth_files.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/inspect_run.h"

namespace spool {
namespace {

namespace fs = std::filesystem;

// Three frames of a wall 1 m away that leans, bent by `bend` of the depth in the corners; of
// `has_step` a wall's edge runs down the middle.
void write_wall(const fs::path& folder, double bend, bool has_step = false) {
  constexpr int kWidth = 320, kHeight = 240;
  fs::create_directories(folder / "depth");
  std::ofstream(folder / "camera.json") << test::CameraText{.width = "320",
                                                            .height = "240",
                                                            .fx = "288",
                                                            .fy = "288",
                                                            .cx = "159.5",
                                                            .cy = "119.5",
                                                            .depth_unit_m = "0.0001"}
                                               .json();
  std::mt19937 random{4};
  std::normal_distribution<double> noise(0, 0.0019);
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<std::uint16_t> counts;
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const double x = (u + 0.5) / 160 - 1, y = (v + 0.5) / 120 - 1;
        double z = 1 / (1 + 0.1 * (u - 159.5) / 288) * (1 + bend * (x * x + y * y) / 2);
        if (has_step && u < 160) z += 0.4;
        counts.push_back(static_cast<std::uint16_t>(std::lround((z + noise(random)) / 0.0001)));
      }
    std::ofstream(folder / "depth" / ("00000" + std::to_string(frame) + ".png"), std::ios::binary)
        << test::grey_png(counts, kWidth, kHeight);
  }
}

class SensorCheckTool : public testing::Test {
 protected:
  std::string at(const std::string& name) { return (folder_.path() / name).string(); }
  test::ProcessResult run(const std::vector<std::string>& arguments) {
    return test::run(test::program("spoolsight-inspect"), arguments);
  }
  test::TemporaryFolder folder_;
};

TEST_F(SensorCheckTool, WritesACalibrationThatInspectTakesAndNames) {
  write_wall(at("wall"), 0.012);
  const auto check = run({"--sensor-check", at("wall"), "--out", at("out")});
  ASSERT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("does not tell a sensor's scale"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("± 3 mm can be proved"), std::string::npos) << check.out;
  const auto json = read_json(at("out/sensor.json"));
  ASSERT_TRUE(json);
  EXPECT_EQ((*json)["schema"], "spoolsight-sensor/1");
  EXPECT_EQ((*json)["frames"], 3);
  EXPECT_NEAR((*json)["corner_m"].get<double>(), 0.012, 0.004);
  EXPECT_EQ((*json)["warp_map"]["bend_m"].size(), 300U);
  const auto calibration = read_calibration(at("out/sensor.json"));
  ASSERT_TRUE(calibration) << calibration.error().message;
  EXPECT_EQ(calibration->scale_u, 0.005);
  EXPECT_NEAR(calibration->warp.at(1, 1), 0.012, 0.004);
  EXPECT_LT(calibration->warp_u_m, 0.004);
  EXPECT_EQ(calibration->id.find("wall-"), 0U);
  const auto sample = test::source_dir() / "assets" / "sample";
  const auto inspected =
      test::run_inspect({"--design", (sample / "spool.glb").string(), "--scan",
                         (sample / "recording").string(), "--calibration", at("out/sensor.json")},
                        folder_.path() / "report");
  EXPECT_EQ(inspected.report["sensor"]["calibration"]["id"], calibration->id);
  EXPECT_EQ(inspected.report["sensor"]["calibration"]["warp"].size(), 12U);
  EXPECT_NE(inspected.html.find("its warp is taken off"), std::string::npos);
}

TEST_F(SensorCheckTool, KeepsTheScaleThatIsKnown) {
  write_wall(at("wall"), 0);
  std::ofstream(at("bar.json")) << R"({"calibration": {"id": "bar", "scale_u": 0.0004}})";
  const auto check =
      run({"--sensor-check", at("wall"), "--calibration", at("bar.json"), "--out", at("out")});
  ASSERT_EQ(check.code, 0) << check.err;
  EXPECT_EQ(read_calibration(at("out/sensor.json"))->scale_u, 0.0004);
}

TEST_F(SensorCheckTool, RefusesWhatIsNoWall) {
  write_wall(at("step"), 0, true);
  std::ofstream(at("bent.json")) << R"({"calibration": {"warp": [9,0,0,0,0,0,0,0,0,0,0,0]}})";
  struct Case {
    std::string name;
    std::vector<std::string> words;
    int code;
    std::string says;
  };
  const std::vector<Case> cases = {
      {"a step", {"--sensor-check", at("step")}, 65, "bare floor or wall"},
      {"nothing there", {"--sensor-check", at("no")}, 64, "is no source"},
      {"a design too", {"--sensor-check", at("step"), "--design", "d.glb"}, 64, "--sensor-check"},
      {"no design", {"--scan", at("step")}, 64, "--design is required"},
      {"no scan", {"--design", "d.glb"}, 64, "--scan is required"},
      {"hostile calibration",
       {"--sensor-check", at("step"), "--calibration", at("bent.json")},
       65,
       "calibration.warp"},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    std::vector<std::string> words = each.words;
    words.insert(words.end(), {"--out", at("out")});
    const auto refused = run(words);
    EXPECT_EQ(refused.code, each.code) << refused.err;
    EXPECT_NE(refused.err.find(each.says), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(at("out/sensor.json")));
  }
}

}  // namespace
}  // namespace spool
