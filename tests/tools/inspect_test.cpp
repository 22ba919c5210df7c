// spoolsight-inspect from files to folder on a small scene made by hand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/common/json_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/inspect_run.h"
#include "tests/tools/small_scene.h"
#include "vision/scan/cloud_file.h"

namespace spool {
namespace {

namespace fs = std::filesystem;

class Inspect : public testing::Test {
 protected:
  Inspect() { scene_.write(folder_.path()); }
  std::string at(const std::string& name) { return (folder_.path() / name).string(); }
  // The scene's files with their units said, and `more`.
  std::vector<std::string> words(std::vector<std::string> more) {
    std::vector<std::string> all = {"--design", at("design.obj"), "--design-unit", "m",
                                    "--scan",   at("scan.ply"),   "--scan-unit",   "m"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  test::TemporaryFolder folder_;
  test::SmallScene scene_;
};

TEST_F(Inspect, TakesAPoseAsGivenAndFindsTheNoiseOnEveryPart) {
  const auto run = test::run_inspect(words({"--pose", at("pose.json")}), folder_.path() / "out");
  EXPECT_EQ(run.process.code, 2) << run.process.err;
  EXPECT_EQ(run.report["status"], "suspicious");
  EXPECT_EQ(run.report["alignment"]["method"], "pose");
  const auto given = read_pose(at("pose.json"));
  ASSERT_TRUE(given);
  EXPECT_LT((run.T_design_scan().matrix() - given->matrix()).cwiseAbs().maxCoeff(), 1e-12);
  ASSERT_EQ(run.report["parts"].size(), 2U);
  for (const auto& part : run.report["parts"]) {
    SCOPED_TRACE(part["name"]);
    EXPECT_NE(part["status"], "ok");
    EXPECT_GT(part["coverage"], 0.5);
    // 1 mm of noise across the faces; some thousand points: good to a few per cent. Points near an
    // edge may lie closer to the face round the corner, hence the wider lower side.
    EXPECT_NEAR(part["deviation"]["rms_m"].get<double>(), scene_.noise_m, 0.15 * scene_.noise_m);
    EXPECT_NEAR(part["deviation"]["mean_m"].get<double>(), 0, 0.1 * scene_.noise_m);
  }
  // The summary says the same, first thing.
  EXPECT_EQ(run.process.out.find("suspicious: "), 0U) << run.process.out;
  EXPECT_NE(run.process.out.find((folder_.path() / "out").string()), std::string::npos);
}

TEST_F(Inspect, WritesEveryScanPointInOrderInTheDesignFrame) {
  const auto run = test::run_inspect(words({"--pose", at("pose.json")}), folder_.path() / "out");
  const auto scan = read_cloud(at("scan.ply"), LengthUnit::kMetre);
  ASSERT_TRUE(scan);
  ASSERT_EQ(run.points.size(), scan->cloud.size());
  const auto T_design_scan = run.T_design_scan();
  std::size_t object = 0;
  for (std::size_t i = 0; i < run.points.size(); ++i) {
    const Eigen::Vector3d expected =
        T_design_scan * (scan->cloud.points[i].cast<double>() + scan->cloud.origin);
    const Eigen::Vector3d written(run.points[i].position[0], run.points[i].position[1],
                                  run.points[i].position[2]);
    ASSERT_LT((written - expected).norm(), 1e-6) << i;
    const bool kept = run.points[i].object != 0;
    object += kept ? 1 : 0;
    EXPECT_EQ(kept, run.points[i].part >= 0);
    EXPECT_EQ(kept, std::isfinite(run.points[i].deviation));
  }
  const auto& counts = run.report["declutter"];
  EXPECT_EQ(counts["points_in"], run.points.size());
  EXPECT_EQ(object, counts["points_object"].get<std::size_t>() +
                        counts["points_contradicting"].get<std::size_t>());
}

TEST_F(Inspect, RecoversThePoseFromPicksThatAreOff) {
  const auto run = test::run_inspect(words({"--pairs", at("pairs.json")}), folder_.path() / "out");
  EXPECT_EQ(run.process.code, 2) << run.process.err;
  EXPECT_EQ(run.report["alignment"]["method"], "three-point");
  EXPECT_EQ(run.report["alignment"]["pair_residual_m"].size(), 3U);
  const auto truth = read_pose(at("pose.json"));
  ASSERT_TRUE(truth);
  const auto error = test::difference(run.T_design_scan(), *truth,
                                      truth->inverse() * Eigen::Vector3d(0.3, 0.1, 0.05));
  // Some 4000 points of 1 mm: the fit itself is good to 0.05 mm; a floor 50 mm away pulls at most a
  // little.
  EXPECT_LT(error.shift_m, 0.0005);
  EXPECT_LT(error.angle_rad, 0.002);
}

TEST_F(Inspect, DrawsPicturesOrSaysThatThereAreNone) {
  const auto run = test::run_inspect(words({"--pose", at("pose.json")}), folder_.path() / "out");
  if (run.pictures.empty()) {
    EXPECT_EQ(std::getenv("SPOOL_REQUIRE_GL"), nullptr);
    EXPECT_NE(run.html.find("No pictures"), std::string::npos);
    GTEST_SKIP() << "no GL driver";
  }
  EXPECT_GE(run.pictures.size(), 2U);
  std::size_t embedded = 0;
  for (auto place = run.html.find("data:image/png;base64,"); place != std::string::npos;
       place = run.html.find("data:image/png;base64,", place + 1))
    ++embedded;
  EXPECT_EQ(embedded, run.pictures.size());
}

TEST_F(Inspect, WritesItsReportWithoutAGraphicsDriver) {
  // A vendor list that names no driver: EGL is there and finds nothing.
  const auto all = words({"--pose", at("pose.json"), "--out", at("out")});
  const auto process =
      test::run(test::program("spoolsight-inspect"), all,
                {.file_size_limit_bytes = 0,
                 .environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", at("none.json")}}});
  EXPECT_EQ(process.code, 2) << process.err;
  const auto report = read_json(folder_.path() / "out" / "report.json");
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_NE((*report)["warnings"].dump().find("no pictures"), std::string::npos)
      << (*report)["warnings"];
  EXPECT_FALSE(fs::exists(folder_.path() / "out" / "overlay_1.png"));
}

TEST_F(Inspect, GivesTheSameReportTwiceApartFromTimes) {
  auto first = test::run_inspect(words({"--pairs", at("pairs.json")}), folder_.path() / "one");
  auto second = test::run_inspect(words({"--pairs", at("pairs.json")}), folder_.path() / "two");
  for (auto* report : {&first.report, &second.report}) {
    report->erase("timing_s");
    report->erase("created");
    (*report)["alignment"].erase("seconds");
  }
  EXPECT_EQ(first.report, second.report);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    EXPECT_EQ(first.points[i].position, second.points[i].position);
    EXPECT_EQ(first.points[i].object, second.points[i].object);
  }
}

TEST_F(Inspect, NamesAUnitThatItHadToInfer) {
  const auto run = test::run_inspect(
      {"--design", at("design.obj"), "--scan", at("scan.ply"), "--pose", at("pose.json")},
      folder_.path() / "out");
  if (run.report.is_null()) return;  // failed above
  EXPECT_TRUE(run.report["design"]["unit_inferred"]);
  EXPECT_TRUE(run.report["scan"]["unit_inferred"]);
  EXPECT_NE(run.report["status"], "ok");
  EXPECT_GE(run.report["warnings"].size(), 2U);
}

// Drawn in millimetres and taken for metres, or the other way round.
TEST_F(Inspect, HintsAtTheUnitsWhereTheSizesAreAUnitApart) {
  for (const bool is_design_wrong : {true, false}) {
    const auto run = test::run_inspect(
        {"--design", at("design.obj"), "--design-unit", is_design_wrong ? "mm" : "m", "--scan",
         at("scan.ply"), "--scan-unit", is_design_wrong ? "m" : "mm", "--align", "find"},
        folder_.path() / "out");
    EXPECT_FALSE(run.report["alignment"]["found"]);
    EXPECT_NE(run.report["warnings"].dump().find("check --scan-unit and --design-unit"),
              std::string::npos)
        << run.report["warnings"];
  }
  const auto run = test::run_inspect(words({"--align", "find"}), folder_.path() / "out");
  EXPECT_EQ(run.report["warnings"].dump().find("check --scan-unit"), std::string::npos)
      << run.report["warnings"];
}

TEST_F(Inspect, NamesDatumStandardCalibrationAndDisplayUnits) {
  std::ofstream(folder_.path() / "calibration.json")
      << R"({"calibration": {"id": "bar-1", "date": "2024-03-01", "scale_u": 0.001}})";
  const auto run = test::run_inspect(
      words({"--pose", at("pose.json"), "--datum", "short,long", "--standard", "iso-13920-BF",
             "--calibration", at("calibration.json"), "--units", "ft-in", "--seed", "7"}),
      folder_.path() / "out");
  EXPECT_EQ(run.report["datum"], nlohmann::json({"short", "long"}));
  EXPECT_EQ(run.report["standard"], "iso-13920-BF");
  EXPECT_EQ(run.report["sensor"]["calibration"]["id"], "bar-1");
  EXPECT_NE(run.html.find("1/16&quot;"), std::string::npos);
}

TEST_F(Inspect, JudgesDimensionsByTheShopsOwnRulesFromTheDatumAsked) {
  std::ofstream(folder_.path() / "shop.json")
      << R"({"name": "Shop 7", "length_by_nps": {"clause": "4.1", "steps": [{"tolerance_mm": 2}]}})";
  const auto sample = test::source_dir() / "assets" / "sample";
  const auto run = test::run_inspect(
      {"--design", (sample / "spool.glb").string(), "--scan", (sample / "recording").string(),
       "--standard", at("shop.json"), "--datum", "F2"},
      folder_.path() / "out");
  ASSERT_TRUE(run.report["alignment"]["found"]) << run.report["alignment"]["reason"];
  EXPECT_EQ(run.report["standard"], at("shop.json"));
  // One frame from one side: the datum's face looks away, so nothing is said to be relative to it.
  EXPECT_NE(run.report["datum_text"].get<std::string>().find("not measured"), std::string::npos);
  std::size_t lengths = 0, measured = 0;
  for (const auto& dimension : run.report["dimensions"]) {
    if (dimension["kind"] == "offset") {
      EXPECT_EQ(dimension["status"], "not_measured");
    }
    if (!dimension.contains("nominal_m") || dimension["kind"] == "offset") continue;
    ++lengths;
    EXPECT_EQ(dimension["rule"], "Shop 7 4.1");
    EXPECT_DOUBLE_EQ(dimension["tolerance_m"].get<double>(), 0.002);
    if (!dimension.contains("measured_m")) continue;
    ++measured;
    // As built in all but E2's roll.
    EXPECT_LT(std::abs(dimension["deviation_m"].get<double>()), 2 * dimension["u_m"].get<double>());
    // camera.json has no calibration: half a percent, and what diameters seen in one frame narrow.
    const double scale_u = run.report["sensor"]["scale_check"]["scale_u"].get<double>();
    EXPECT_NEAR(scale_u, 0.005, 0.0005);
    EXPECT_NEAR(dimension["budget_m"]["scale"].get<double>(),
                scale_u * dimension["measured_m"].get<double>(), 1e-9);
  }
  EXPECT_EQ(lengths, 5U);
  EXPECT_GE(measured, 1U);
  EXPECT_NE(run.process.out.find("centre_to_centre E1/centre to T1/centre"), std::string::npos);
}

TEST_F(Inspect, RefusesPicksOnALineWithTheReasonInAReport) {
  std::ofstream(folder_.path() / "line.json") << R"({"pairs": [{"design": [0,0,0], "scan": [0,0,0]},
    {"design": [0.1,0,0], "scan": [0.1,0,0]}, {"design": [0.3,0,0], "scan": [0.3,0,0]}]})";
  const auto run = test::run_inspect(words({"--pairs", at("line.json")}), folder_.path() / "out");
  EXPECT_EQ(run.process.code, 3) << run.process.err;
  EXPECT_FALSE(run.report["alignment"]["found"]);
  EXPECT_TRUE(run.report["alignment"]["T_design_scan"].is_null());
  EXPECT_FALSE(run.report["alignment"]["reason"].get<std::string>().empty());
  EXPECT_EQ(run.report["status"], "not_measured");
  EXPECT_TRUE(run.pictures.empty());  // a design drawn where it was not found would be a lie
  EXPECT_NE(run.html.find("not placed on the scan"), std::string::npos);
  for (const auto& row : run.points) EXPECT_EQ(row.object, 0);
}

}  // namespace
}  // namespace spool
