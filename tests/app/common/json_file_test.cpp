// Pairs, poses, cameras and calibrations: read back exactly, or refused by file and key.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/json_file.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/depth_files.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool {
namespace {

// A file of `text` in a folder that lives as long as this.
class TextFile {
 public:
  explicit TextFile(const std::string& text, const std::string& name = "given.json")
      : path_(folder_.path() / name) {
    test::write_file(path_, text);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path path_;
};

constexpr const char* kGoodPairs = R"({"pairs": [{"design": [0,0,0], "scan": [1,2,3]},
  {"design": [1,0,0], "scan": [2,2,3]}, {"design": [0,1,0.5], "scan": [1,3,3.5]}]})";

TEST(PairsJson, GivesEveryPairInOrder) {
  const TextFile file(kGoodPairs);
  const auto pairs = read_pairs(file.path());
  ASSERT_TRUE(pairs) << pairs.error().message;
  ASSERT_EQ(pairs->size(), 3U);
  EXPECT_EQ((*pairs)[2].design, Eigen::Vector3d(0, 1, 0.5));
  EXPECT_EQ((*pairs)[2].scan, Eigen::Vector3d(1, 3, 3.5));
}

TEST(PoseJson, GivesTheRowMajorPose) {
  const TextFile file(R"({"T_design_scan": [0,-1,0,0.1, 1,0,0,0.2, 0,0,1,0.3, 0,0,0,1]})");
  const auto pose = read_pose(file.path());
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_LT((*pose * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0.1, 1.2, 0.3)).norm(), 1e-12);
}

TEST(CameraJson, RoundTripsWithItsCalibration) {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 575.8;
  camera.fy = 575.5;
  camera.cx = 319.25;
  camera.cy = 240.5;
  camera.depth_unit_m = 0.0001;
  camera.calibration = {"gauge-7", "2024-05-01", 0.0012, 0.0004};
  for (std::size_t k = 0; k < DepthWarp::kTerms; ++k)
    camera.calibration.warp.share[k] = 0.001 * (static_cast<double>(k) - 5);
  const TextFile file(json_text(camera_to_json(camera)));
  const auto read = read_camera(file.path());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->width, 640);
  EXPECT_EQ(read->fy, 575.5);
  EXPECT_EQ(read->cx, 319.25);
  EXPECT_EQ(read->depth_unit_m, 0.0001);
  EXPECT_EQ(read->calibration.id, "gauge-7");
  EXPECT_EQ(read->calibration.scale_u, 0.0012);
  const auto calibration = read_calibration(file.path());
  ASSERT_TRUE(calibration) << calibration.error().message;
  EXPECT_EQ(calibration->warp_u_m, 0.0004);
  EXPECT_EQ(calibration->warp.share, camera.calibration.warp.share);
}

TEST(CameraJson, WithoutCalibrationKeepsHalfAPercent) {
  const TextFile file(test::CameraText{}.json());
  const auto camera = read_camera(file.path());
  ASSERT_TRUE(camera) << camera.error().message;
  EXPECT_TRUE(camera->calibration.id.empty());
  EXPECT_EQ(camera->calibration.scale_u, 0.005);
}

struct Refusal {
  const char* name;
  std::string text;
  const char* sentence;  // has to be part of the message
};

template <class Read>
void expect_refused(const std::vector<Refusal>& cases, const Read& read) {
  for (const auto& [name, text, sentence] : cases) {
    SCOPED_TRACE(name);
    const TextFile file(text);
    const auto result = read(file.path());
    test::expect_refused(result, ErrorCode::kBadInput, file.path().string() + ": ", sentence);
  }
}

TEST(PairsJson, RefusesWhatIsNoListOfThreePairsByFileAndKey) {
  expect_refused(
      {
          {"empty", "", "is empty"},
          {"blank", " \n\t", "is empty"},
          {"cut short", R"({"pairs": [{"design": [0,0)", "line 1"},
          {"wrong kind", "ply\nformat ascii 1.0\n", "is not valid JSON at line 1"},
          {"no key", R"({"points": []})", "\"pairs\" is missing"},
          {"no object", "[1, 2]", "has to be an object"},
          {"no list", R"({"pairs": 3})", "\"pairs\" has to be a list"},
          {"two pairs",
           R"({"pairs": [{"design":[0,0,0],"scan":[0,0,0]},{"design":[1,0,0],"scan":[1,0,0]}]})",
           "holds 2 pairs and three or more are needed"},
          {"two numbers", R"({"pairs": [{"design": [0,0], "scan": [0,0,0]}]})",
           "\"pairs[0].design\" has to be a list of 3 numbers"},
          {"a text", R"({"pairs": [{"design": [0,0,"x"], "scan": [0,0,0]}]})", "pairs[0].design"},
          {"null for NaN", R"({"pairs": [{"design": [0,0,0], "scan": [0,null,0]}]})",
           "pairs[0].scan"},
          {"NaN", R"({"pairs": [{"design": [0,0,NaN], "scan": [0,0,0]}]})", "is not valid JSON"},
          {"beyond double", R"({"pairs": [{"design": [0,0,1e999], "scan": [0,0,0]}]})",
           "out of range"},
          {"entry no object", R"({"pairs": [7]})", "pairs[0]"},
      },
      [](const auto& path) { return read_pairs(path); });
}

TEST(PoseJson, RefusesWhatIsNotRigidAndSaysWhy) {
  expect_refused(
      {
          {"mirror", R"({"T_design_scan": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})", "mirrors"},
          {"scale", R"({"T_design_scan": [0.001,0,0,0, 0,0.001,0,0, 0,0,0.001,0, 0,0,0,1]})",
           "scales by 0.001"},
          {"shear", R"({"T_design_scan": [1,0.3,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})", "not a rigid"},
          {"column-major", R"({"T_design_scan": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]})",
           "row by row"},
          {"zero", R"({"T_design_scan": [0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,1]})", "not a rigid"},
          {"fifteen", R"({"T_design_scan": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]})",
           "has to be a list of 16 numbers"},
          {"no key", R"({})", "\"T_design_scan\" is missing"},
      },
      [](const auto& path) { return read_pose(path); });
}

TEST(CameraJson, RefusesImpossibleIntrinsicsByKey) {
  using test::CameraText;
  expect_refused(
      {
          {"no fx", CameraText{.fx = ""}.json(), "\"fx\" is missing"},
          {"zero", CameraText{.fx = "0"}.json(), "\"fx\" has to be more than 0"},
          {"half a pixel", CameraText{.width = "640.5"}.json(),
           "\"width\" has to be a whole number"},
          {"too wide", CameraText{.width = "64000"}.json(), "intrinsics no camera has"},
          {"all round", CameraText{.fx = "1e-300"}.json(), "intrinsics no camera has"},
          {"a needle's view", CameraText{.fx = "1e6"}.json(), "intrinsics no camera has"},
          {"text", CameraText{.width = "\"640\""}.json(), "\"width\" has to be a number"},
          {"calibration", CameraText{.more = R"(, "calibration": {"scale_u": -1})"}.json(),
           "\"calibration.scale_u\" has to lie between"},
          {"warp too short", CameraText{.more = R"(, "calibration": {"warp": [0, 0, 0]})"}.json(),
           "\"calibration.warp\" has to be a list of 12 numbers"},
          {"warp no list", CameraText{.more = R"(, "calibration": {"warp": 0.5})"}.json(),
           "calibration.warp"},
          {"warp with text",
           CameraText{.more = R"(, "calibration": {"warp": [0,0,0,0,0,0,0,0,0,0,0,"x"]})"}.json(),
           "\"calibration.warp\" has to be a list of 12 numbers"},
          {"warp turns depth round",
           CameraText{.more = R"(, "calibration": {"warp": [-1,0,0,0,0,0,0,0,0,0,0,0]})"}.json(),
           "\"calibration.warp\" bends the picture"},
          {"warp beyond all numbers",
           CameraText{.more = R"(, "calibration": {"warp": [1e308,1e308,0,0,0,0,0,0,0,0,0,0]})"}
               .json(),
           "\"calibration.warp\" bends the picture"},
      },
      [](const auto& path) { return read_camera(path); });
}

TEST(JsonFile, RefusesNestingThatWouldEndTheStack) {
  const std::string deep = std::string(300000, '[') + std::string(300000, ']');
  const auto result = parse_json(deep, "deep.json");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message,
            "deep.json: is nested deeper than 64 levels; this is not a file made for this program");
}

TEST(JsonFile, DoesNotCountBracketsInsideStrings) {
  const auto result = parse_json("{\"text\": \"" + std::string(100, '[') + "\\\"[\"}", "text.json");
  EXPECT_TRUE(result) << result.error().message;
}

TEST(JsonFile, NamesTheLineOfAMistake) {
  const auto result = parse_json("{\n\"a\": 1,\n\"b\": }\n", "line.json");
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("at line 3"), std::string::npos) << result.error().message;
}

TEST(JsonFile, RefusesAFolderAndAMissingFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_json(folder.path()).error().code, ErrorCode::kBadInput);
  EXPECT_EQ(read_json(folder.path() / "none.json").error().code, ErrorCode::kBadInput);
}

TEST(JsonFile, WritesFileNamesThatAreNotUtf8) {
  const std::string text = json_text({{"file", std::string("scan\xff.ply")}});
  EXPECT_TRUE(parse_json(text, "written")) << text;
}

}  // namespace
}  // namespace spool
