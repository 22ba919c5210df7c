// spoolsight-inspect and what it cannot use: the exit code, one sentence, nothing written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "app/sensor/depth_png.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/small_scene.h"

namespace spool {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;

class InspectRefusals : public testing::Test {
 protected:
  InspectRefusals() {
    scene_.write(folder_.path());
    write("empty.ply", "");
    write("empty.json", "");
    write("text.ply", "this is no cloud\n");
    write("no_points.ply",
          "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
          "property float z\nend_header\n");
    write("nan.ply",
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
          "property float z\nend_header\nnan nan nan\nnan nan nan\n");
    const std::string whole = text_of("scan.ply");
    write("cut.ply", whole.substr(0, whole.size() / 2));
    write("cut.glb", std::string("glTF\x02\0\0\0\xff\0\0\0", 12));
    write("empty.glb", "");
    write("two_pairs.json",
          R"({"pairs": [{"design":[0,0,0],"scan":[0,0,0]},{"design":[1,0,0],"scan":[1,0,0]}]})");
    write("mirror.json", R"({"T_design_scan": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})");
    write("calibration.json", R"({"calibration": {"scale_u": 7}})");
    fs::create_directory(folder_.path() / "plain_folder");
    write_depth_folder("no_frames", 640, 480, 0);
    write_depth_folder("two_frames", 4, 3, 2);
    write_depth_folder("wrong_size", 640, 480, 2);
    write_depth_folder("no_lens", 4, 3, 2);
    write(
        "no_lens/camera.json",
        R"({"width": 4, "height": 3, "fx": 0, "fy": 1, "cx": 2, "cy": 1, "depth_unit_m": 0.001})");
    fs::create_directory(folder_.path() / "folder.ply");
  }

  void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
  }
  // A recording of `frames` images of 4x3 px without a reading, whose camera claims another size.
  void write_depth_folder(const std::string& name, int width, int height, int frames) {
    fs::create_directories(folder_.path() / name / "depth");
    Camera camera{.width = width, .height = height, .fx = 500, .fy = 500, .cx = 2, .cy = 1};
    write(name + "/camera.json", json_text(camera_to_json(camera)));
    const auto png = sensor::encode_depth_png(std::vector<std::uint16_t>(12, 0), 4, 3);
    ASSERT_TRUE(png);
    for (int i = 0; i < frames; ++i)
      write(name + "/depth/00000" + std::to_string(i) + ".png", *png);
  }
  std::string text_of(const std::string& name) {
    std::ifstream file(folder_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string at(const std::string& name) { return (folder_.path() / name).string(); }

  // `words` with @name meaning the file of that name in the folder.
  ProcessResult inspect(const std::vector<std::string>& words) {
    std::vector<std::string> arguments;
    for (const auto& word : words) arguments.push_back(word[0] == '@' ? at(word.substr(1)) : word);
    return test::run(test::program("spoolsight-inspect"), arguments);
  }

  test::TemporaryFolder folder_;
  test::SmallScene scene_;
};

struct Case {
  const char* name;
  std::vector<std::string> words;  // beside --out
  int code;
  const char* sentence;  // part of the one line on stderr
};

TEST_F(InspectRefusals, AnswerEveryBadInputWithItsCodeAndOneSentence) {
  const std::vector<Case> cases = {
      {"nothing given", {}, 64, "--design"},
      {"no scan", {"--design", "@design.obj"}, 64, "--scan"},
      {"unknown flag", {"--design", "@design.obj", "--scan", "@scan.ply", "--fast"}, 64, "--fast"},
      {"unknown unit",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--scan-unit", "ft"},
       64,
       "scan-unit"},
      {"no such method",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--align", "guess"},
       64,
       "guess is no method"},
      {"two designs and a pose",
       {"--design", "@design.obj", "--design", "@design.obj", "--scan", "@scan.ply", "--pose",
        "@pose.json"},
       64,
       "one design"},
      {"pose without file",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--align", "pose"},
       64,
       "--pose FILE"},
      {"pairs without file",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--align", "three-point"},
       64,
       "--pairs FILE"},
      {"both",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pairs", "@pairs.json", "--pose",
        "@pose.json"},
       64,
       "contradict"},
      {"pose and pairs method",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pose", "@pose.json", "--align",
        "principal-axes"},
       64,
       "--pose is for"},
      {"frame of a cloud",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--frame", "2", "--scan-unit", "m",
        "--design-unit", "m"},
       64,
       "--frame is for recordings"},
      {"negative frame",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--frame", "-2"},
       64,
       "--frame"},
      {"unknown datum",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@scan.ply", "--datum", "F9"},
       64,
       "--datum F9"},
      {"design missing", {"--design", "@none.glb", "--scan", "@scan.ply"}, 65, "none.glb"},
      {"design empty", {"--design", "@empty.glb", "--scan", "@scan.ply"}, 65, "empty.glb"},
      {"design cut short", {"--design", "@cut.glb", "--scan", "@scan.ply"}, 65, "cut.glb"},
      {"design is a scan's kind of text",
       {"--design", "@text.ply", "--scan", "@scan.ply"},
       65,
       "text.ply"},
      {"design is a folder",
       {"--design", "@plain_folder", "--scan", "@scan.ply"},
       65,
       "plain_folder"},
      {"scan missing",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@none.ply"},
       65,
       "none.ply"},
      {"scan empty",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@empty.ply"},
       65,
       "empty.ply"},
      {"scan cut short",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@cut.ply", "--scan-unit", "m"},
       65,
       "cut.ply"},
      {"scan of wrong kind",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@text.ply", "--scan-unit", "m"},
       65,
       "text.ply"},
      {"scan without points",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@no_points.ply", "--scan-unit",
        "m"},
       65,
       "no_points.ply"},
      {"scan of NaN alone",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@nan.ply", "--scan-unit", "m"},
       65,
       "nan.ply"},
      {"scan a folder named as a file",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@folder.ply", "--scan-unit",
        "m"},
       65,
       "folder.ply"},
      {"scan a folder without frames",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@plain_folder"},
       65,
       "plain_folder"},
      {"scan a folder without images",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@no_frames"},
       65,
       "no_frames"},
      {"depth frame of the wrong size",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@wrong_size"},
       65,
       "wrong_size"},
      {"depth frame without a reading",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@two_frames"},
       65,
       "measured nothing"},
      {"frame beyond the end",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@two_frames", "--frame", "2"},
       65,
       "no frame 2"},
      {"camera without a lens",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@no_lens"},
       65,
       "\"fx\" has to be more than 0"},
      {"unit of a recording",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@two_frames", "--scan-unit",
        "mm"},
       64,
       "--scan-unit is for cloud files"},
      {"camera that is not there",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "openni:no/such"},
       69,
       "openni:no/such"},
      {"scan recording missing",
       {"--design", "@design.obj", "--design-unit", "m", "--scan", "@none.oni"},
       65,
       "none.oni"},
      {"pairs missing",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pairs", "@none.json"},
       65,
       "none.json"},
      {"pairs empty",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pairs", "@empty.json"},
       65,
       "empty.json: is empty"},
      {"two pairs",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pairs", "@two_pairs.json"},
       65,
       "three or more"},
      {"pose mirrored",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--pose", "@mirror.json"},
       65,
       "mirrors"},
      {"calibration impossible",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--calibration", "@calibration.json"},
       65,
       "calibration.scale_u"},
      {"standard missing",
       {"--design", "@design.obj", "--scan", "@scan.ply", "--standard", "@none.json"},
       65,
       "none.json"},
  };
  for (const auto& [name, words, code, sentence] : cases) {
    SCOPED_TRACE(name);
    auto arguments = words;
    arguments.insert(arguments.end(), {"--out", "@out"});
    const auto result = inspect(arguments);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_EQ(result.signal, 0);
    EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("spoolsight-inspect: "), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
  }
}

TEST_F(InspectRefusals, RefuseAnOutputFolderThatIsAFile) {
  const auto result =
      inspect({"--design", "@design.obj", "--design-unit", "m", "--scan", "@scan.ply",
               "--scan-unit", "m", "--pose", "@pose.json", "--out", "@empty.ply"});
  EXPECT_EQ(result.code, 74) << result.err;
  EXPECT_NE(result.err.find("empty.ply"), std::string::npos) << result.err;
}

TEST_F(InspectRefusals, LeaveTheEarlierReportWhenTheDiskIsFull) {
  const std::vector<std::string> words = {"--design", at("design.obj"), "--design-unit", "m",
                                          "--scan",   at("scan.ply"),   "--scan-unit",   "m",
                                          "--pose",   at("pose.json"),  "--out",         at("out")};
  const auto program = test::program("spoolsight-inspect");
  const auto first = test::run(program, words);
  ASSERT_EQ(first.code, 2) << first.err;
  const std::string report = text_of("out/report.json");
  std::vector<fs::path> before;
  for (const auto& entry : fs::directory_iterator(folder_.path() / "out"))
    before.push_back(entry.path());
  // Smaller than any of the files that are written, larger than what is said on stdout and stderr.
  const auto full = test::run(program, words, {.file_size_limit_bytes = 3000, .environment = {}});
  EXPECT_EQ(full.code, 74) << full.err;
  EXPECT_EQ(full.signal, 0);
  EXPECT_NE(full.err.find((folder_.path() / "out").string()), std::string::npos) << full.err;
  EXPECT_EQ(text_of("out/report.json"), report);
  std::vector<fs::path> after;
  for (const auto& entry : fs::directory_iterator(folder_.path() / "out"))
    after.push_back(entry.path());
  EXPECT_EQ(before.size(), after.size());
}

TEST_F(InspectRefusals, HelpAndVersionAnswerWithoutInput) {
  const auto help = inspect({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* flag : {"--design", "--scan", "--align", "--pairs", "--pose", "--datum",
                           "--standard", "--design-unit", "--scan-unit", "--units", "--calibration",
                           "--seed", "--out", "--frame", "--log-level", "--version"})
    EXPECT_NE(help.out.find(flag), std::string::npos) << flag;
  const auto version = inspect({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.find("spoolsight-inspect "), 0U) << version.out;
}

}  // namespace
}  // namespace spool
