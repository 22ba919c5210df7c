// spoolsight-simulate and spoolsight-record as a person runs them.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;

// A plate before the camera, small and quick.
fs::path write_scene(const fs::path& folder) {
  std::ofstream(folder / "scene.json") << R"({"table": null, "floor": false,
    "clutter": [{"kind": "box", "size_m": [3, 0.1, 3], "position_m": [0, 1.05, 0]}],
    "trajectory": {"kind": "fixed", "T_map_camera": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 0,0,0,1]},
    "sensor": {"width": 160, "height": 120}})";
  return folder / "scene.json";
}

class Record : public ::testing::Test {
 protected:
  Record() { setenv("XDG_CACHE_HOME", (folder() / "cache").c_str(), 1); }
  fs::path folder() const { return temporary_.path(); }
  std::string at(const char* name) const { return (folder() / name).string(); }
  ProcessResult simulate(const char* out, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {
        "--scene", write_scene(folder()).string(), "--frames", "3", "--out", at(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(program("spoolsight-simulate"), arguments);
  }

 private:
  TemporaryFolder temporary_;
};

TEST_F(Record, SimulatesADepthFolderWithItsTruth) {
  const ProcessResult result = simulate("sim", {"--merged-cloud"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* file :
       {"camera.json", "times.csv", "depth/000002.png", "truth.json", "cloud.ply"})
    EXPECT_TRUE(fs::exists(folder() / "sim" / file)) << file;
  const auto truth = read_json(folder() / "sim" / "truth.json");
  ASSERT_TRUE(truth) << truth.error().message;
  EXPECT_EQ((*truth)["frames"].size(), 3u);
  EXPECT_EQ(simulate("sim").code, 64) << "never into a folder that holds something";
}

TEST_F(Record, TakesADepthFolderToOniAndBackUnchanged) {
  ASSERT_EQ(simulate("sim").code, 0);
  ProcessResult result = run(program("spoolsight-record"), {at("sim"), "--out", at("a.oni")});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("3 frames"), std::string::npos) << result.out;
  result =
      run(program("spoolsight-record"), {at("a.oni"), "--out", at("back"), "--first-frame", "1"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (int i = 0; i < 2; ++i) {
    const auto name = [](int n) { return "depth/00000" + std::to_string(n) + ".png"; };
    EXPECT_EQ(*read_file(folder() / "back" / name(i)), *read_file(folder() / "sim" / name(i + 1)));
  }
}

TEST_F(Record, RecordsTheSimulatedCamera) {
  const ProcessResult result =
      run(program("spoolsight-record"),
          {"simulated:" + write_scene(folder()).string(), "--frames", "2", "--out", at("live")});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder() / "live" / "depth" / "000001.png"));
}

TEST_F(Record, EndsWithTheExitCodeAndOneSentence) {
  ASSERT_EQ(simulate("sim").code, 0);
  std::ofstream(folder() / "bad.oni") << "no recording";
  struct Case {
    std::vector<std::string> arguments;
    int code;
    const char* says;
  };
  const Case cases[] = {
      {{}, 64, "source"},
      {{at("sim")}, 64, "--out"},
      {{at("sim"), "--out", at("x"), "--frames", "-1"}, 64, "--frames"},
      {{"nothing", "--out", at("x")}, 64, "is no source"},
      {{at("bad.oni"), "--out", at("x")}, 65, "bad.oni"},
      {{at("sim"), "--out", at("sim")}, 64, "already holds something"},
      {{at("sim"), "--out", "/proc/none/x"}, 74, "/proc/none"},
  };
  for (const Case& one : cases) {
    const ProcessResult result = run(program("spoolsight-record"), one.arguments);
    EXPECT_EQ(result.code, one.code) << result.err;
    EXPECT_NE(result.err.find(one.says), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace spool::test
