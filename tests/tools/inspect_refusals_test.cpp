// spoolsight-inspect and what it cannot use: the exit code, one sentence, nothing written.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/depth_files.h"
#include "tests/support/process.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "tests/tools/small_scene.h"

namespace spool {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;

// A command line, @name meaning the file of that name in the test's folder.
using Words = std::vector<std::string>;

Words words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}
// What every run needs and, where it is not about the design, is right; then what a row is about.
Words with_scan(const std::string& scan, const std::string& more = "") {
  return words("--design @design.obj --design-unit m --scan " + scan + " " + more);
}
Words with_cloud(const std::string& cloud) { return with_scan(cloud, "--scan-unit m"); }
Words good_and(const std::string& more) { return with_scan("@scan.ply", more); }

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
    fs::create_directory(folder_.path() / "folder.ply");
    write_recording("no_frames", {}, 0);
    write_recording("two_frames", {.width = "4", .height = "3"}, 2);
    write_recording("wrong_size", {}, 2);
    write_recording("no_lens", {.width = "4", .height = "3", .fx = "0"}, 2);
  }

  void write(const std::string& name, std::string_view bytes) {
    test::write_file(folder_.path() / name, bytes);
  }
  // Images of 4x3 px without a reading, whatever the camera says.
  void write_recording(const std::string& name, const test::CameraText& camera, int frames) {
    test::write_blank_recording(folder_.path() / name, camera, frames, 4, 3);
  }
  std::string text_of(const std::string& name) {
    std::ifstream file(folder_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string at(const std::string& name) { return (folder_.path() / name).string(); }

  ProcessResult inspect(const Words& words) {
    Words arguments;
    for (const auto& word : words) arguments.push_back(word[0] == '@' ? at(word.substr(1)) : word);
    return test::run(test::program("spoolsight-inspect"), arguments);
  }

  test::TemporaryFolder folder_;
  test::SmallScene scene_;
};

struct Case {
  const char* name;
  Words words;  // beside --out
  int code;
  const char* sentence;  // part of the one line on stderr
};

TEST_F(InspectRefusals, AnswerEveryBadInputWithItsCodeAndOneSentence) {
  const std::vector<Case> cases = {
      {"nothing given", {}, 64, "--design"},
      {"no scan", words("--design @design.obj"), 64, "--scan"},
      {"unknown flag", good_and("--fast"), 64, "--fast"},
      {"unknown unit", good_and("--scan-unit ft"), 64, "scan-unit"},
      {"no such method", good_and("--align guess"), 64, "guess is no method"},
      {"two designs and a pose",
       words("--design @design.obj --design @design.obj --scan @scan.ply --pose @pose.json"), 64,
       "one design"},
      {"pose without file", good_and("--align pose"), 64, "--pose FILE"},
      {"pairs without file", good_and("--align three-point"), 64, "--pairs FILE"},
      {"both", good_and("--pairs @pairs.json --pose @pose.json"), 64, "contradict"},
      {"pose and pairs method", good_and("--pose @pose.json --align principal-axes"), 64,
       "--pose is for"},
      {"frame of a cloud", good_and("--frame 2 --scan-unit m"), 64, "--frame is for recordings"},
      {"negative frame", good_and("--frame -2"), 64, "--frame"},
      {"unknown datum", good_and("--datum F9"), 64, "--datum F9"},
      {"design missing", words("--design @none.glb --scan @scan.ply"), 65, "none.glb"},
      {"design empty", words("--design @empty.glb --scan @scan.ply"), 65, "empty.glb"},
      {"design cut short", words("--design @cut.glb --scan @scan.ply"), 65, "cut.glb"},
      {"design is a scan's kind of text", words("--design @text.ply --scan @scan.ply"), 65,
       "text.ply"},
      {"design is a folder", words("--design @plain_folder --scan @scan.ply"), 65, "plain_folder"},
      {"scan missing", with_scan("@none.ply"), 65, "none.ply"},
      {"scan empty", with_scan("@empty.ply"), 65, "empty.ply"},
      {"scan cut short", with_cloud("@cut.ply"), 65, "cut.ply"},
      {"scan of wrong kind", with_cloud("@text.ply"), 65, "text.ply"},
      {"scan without points", with_cloud("@no_points.ply"), 65, "no_points.ply"},
      {"scan of NaN alone", with_cloud("@nan.ply"), 65, "nan.ply"},
      {"scan a folder named as a file", with_cloud("@folder.ply"), 65, "folder.ply"},
      {"scan a folder without frames", with_scan("@plain_folder"), 65, "plain_folder"},
      {"scan a folder without images", with_scan("@no_frames"), 65, "no_frames"},
      {"depth frame of the wrong size", with_scan("@wrong_size"), 65, "wrong_size"},
      {"depth frame without a reading", with_scan("@two_frames"), 65, "measured nothing"},
      {"frame beyond the end", with_scan("@two_frames", "--frame 2"), 65, "no frame 2"},
      {"camera without a lens", with_scan("@no_lens"), 65, "\"fx\" has to be more than 0"},
      {"unit of a recording", with_scan("@two_frames", "--scan-unit mm"), 64,
       "--scan-unit is for cloud files"},
      {"camera that is not there", with_scan("openni:no/such"), 69, "openni:no/such"},
      {"scan recording missing", with_scan("@none.oni"), 65, "none.oni"},
      {"pairs missing", good_and("--pairs @none.json"), 65, "none.json"},
      {"pairs empty", good_and("--pairs @empty.json"), 65, "empty.json: is empty"},
      {"two pairs", good_and("--pairs @two_pairs.json"), 65, "three or more"},
      {"pose mirrored", good_and("--pose @mirror.json"), 65, "mirrors"},
      {"calibration impossible", good_and("--calibration @calibration.json"), 65,
       "calibration.scale_u"},
      {"standard missing", good_and("--standard @none.json"), 65, "none.json"},
  };
  for (const Case& row : cases) {
    SCOPED_TRACE(row.name);
    Words arguments = row.words;
    arguments.insert(arguments.end(), {"--out", "@out"});
    test::expect_refused(inspect(arguments), "spoolsight-inspect", row.code, row.sentence);
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
  }
}

TEST_F(InspectRefusals, RefuseAnOutputFolderThatIsAFile) {
  const auto result = inspect(good_and("--scan-unit m --pose @pose.json --out @empty.ply"));
  test::expect_refused(result, "spoolsight-inspect", 74, "empty.ply");
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
