// From an inspection of the sample to evidence that is verified and made again, as a person does
// it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

class EvidenceTool : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const auto made = run(program("spoolsight-job"),
                          {"new", source_dir() / "assets/sample/spool.glb", "-o", job()});
    ASSERT_EQ(made.code, 0) << made.err;
    const auto keys = run(program("spoolsight-job"), {"keygen", "-o", at("shop.key")});
    ASSERT_EQ(keys.code, 0) << keys.err;
    const auto inspected = inspect({"--design", job() + "/design.glb", "--scan", scan(), "--frame",
                                    "3", "--datum", "F1", "--out", at("report")});
    ASSERT_LT(inspected.code, 4) << inspected.err;
    const auto captured = capture({"--key", at("shop.key")});
    ASSERT_EQ(captured.code, 0) << captured.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string at(const char* name) { return (folder_->path() / name).string(); }
  static std::string job() { return at("sample.spooljob"); }
  static std::string scan() { return source_dir() / "assets/sample/recording"; }
  static ProcessResult inspect(const std::vector<std::string>& arguments) {
    return run(program("spoolsight-inspect"), arguments);
  }
  static ProcessResult capture(const std::vector<std::string>& more,
                               const ProcessOptions& options = {},
                               const std::string& who = "operator 1") {
    std::vector<std::string> all{"capture",    job(),       "--step", "1",          "--report",
                                 at("report"), "--outcome", "redo",   "--operator", who};
    all.insert(all.end(), more.begin(), more.end());
    return run(program("spoolsight-job"), all, options);
  }
  static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> EvidenceTool::folder_;

TEST_F(EvidenceTool, IsIntactAndSaysWhoSigned) {
  const auto verified = inspect({"--verify", job(), "--signer", at("shop.key.pub")});
  EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
  EXPECT_TRUE(holds(verified.out, "signed by ")) << verified.out;
  EXPECT_TRUE(holds(verified.out, "intact: 1 entries, 9 files")) << verified.out;
}

TEST_F(EvidenceTool, HoldsWhatItsNumbersRestOn) {
  const fs::path entry = fs::path(job()) / "evidence/000001";
  for (const char* file : {"report.json", "report.html", "points.ply", "overlay_1.png", "plain.png",
                           "scan/camera.json", "scan/depth/000000.png"})
    EXPECT_TRUE(fs::exists(entry / file)) << file;
  const auto json = nlohmann::json::parse(*read_file(entry / "entry.json"));
  for (const char* key : {"alignment", "datum", "datum_text", "standard", "decision_rule", "sensor",
                          "software", "state", "time", "operator", "part", "options"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["datum"][0], "F1");
  EXPECT_EQ(json["operator"], "operator 1");
}

TEST_F(EvidenceTool, IsTheSameReportAgain) {
  // Where the recording was is of no matter any more: only what is stored is read.
  const auto replayed = inspect({"--replay", job(), "--out", at("again")});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  EXPECT_TRUE(holds(replayed.out, "the largest difference is 0\n")) << replayed.out;
  const auto none = inspect({"--replay", at("report"), "--out", at("again")});
  expect_refused(none, "spoolsight-inspect", 65, "holds no capture");
  expect_refused(inspect({"--replay", job()}), "spoolsight-inspect", 64, "--out");
}

TEST_F(EvidenceTool, WithAnotherFrameIsNoticedByBoth) {
  const std::string copy = at("copy.spooljob");
  fs::copy(job(), copy, fs::copy_options::recursive);
  const fs::path frame = fs::path(copy) / "evidence/000001/scan/depth/000000.png";
  fs::copy(fs::path(scan()) / "depth/000009.png", frame, fs::copy_options::overwrite_existing);
  const auto verified = inspect({"--verify", copy});
  EXPECT_EQ(verified.code, 1);
  EXPECT_TRUE(holds(verified.out, "changed: evidence/000001/scan/depth/000000.png"))
      << verified.out;
  const auto replayed = inspect({"--replay", copy + "/evidence/000001", "--out", at("other")});
  EXPECT_EQ(replayed.code, 1);
  EXPECT_TRUE(holds(replayed.out, "/scan/sha256: is ")) << replayed.out;
  EXPECT_TRUE(holds(replayed.out, "/alignment/T_design_scan/")) << replayed.out;
}

TEST_F(EvidenceTool, IsNotTakenWithoutNameSpaceOrItsOwnScan) {
  const auto unnamed = capture({}, {}, "");
  EXPECT_EQ(unnamed.code, 64) << unnamed.err;
  const auto full = capture({}, {.file_size_limit_bytes = 20000});
  EXPECT_EQ(full.code, 74) << full.err;
  const fs::path frames = fs::path(at("frames"));
  fs::create_directories(frames / "depth");
  fs::copy(fs::path(scan()) / "camera.json", frames / "camera.json");
  for (int i = 0; i < 4; ++i)
    fs::copy(fs::path(scan()) / "depth/000009.png",
             frames / "depth" / ("00000" + std::to_string(i) + ".png"));
  expect_refused(capture({"--scan", frames.string()}), "spoolsight-job", 65,
                 "is not the recording that the report was made with");
  EXPECT_FALSE(fs::exists(fs::path(job()) / "evidence/000002"));
  const auto verified = inspect({"--verify", job()});
  EXPECT_EQ(verified.code, 0) << verified.out;
}

TEST_F(EvidenceTool, OfACloudWithFilesOfItsOwnIsMadeAgainWithThem) {
  // The report's points are a cloud that lies on the design already; the pose file says so.
  write_file(
      at("pose.json"),
      nlohmann::json{{"T_design_scan", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}.dump());
  fs::copy(at("report") + "/points.ply", at("cloud.ply"));
  const auto inspected =
      inspect({"--design", job() + "/design.glb", "--scan", at("cloud.ply"), "--scan-unit", "m",
               "--pose", at("pose.json"), "--out", at("posed")});
  ASSERT_LT(inspected.code, 4) << inspected.err;
  const std::string own = at("cloud.spooljob");
  ASSERT_EQ(run(program("spoolsight-job"), {"new", job() + "/design.glb", "-o", own}).code, 0);
  const auto captured =
      run(program("spoolsight-job"), {"capture", own, "--step", "1", "--report", at("posed"),
                                      "--outcome", "redo", "--operator", "operator 1"});
  ASSERT_EQ(captured.code, 0) << captured.err;
  fs::remove(at("cloud.ply"));
  fs::remove(at("pose.json"));
  const auto replayed = inspect({"--replay", own, "--out", at("posed again")});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
}

}  // namespace
}  // namespace spool::test
