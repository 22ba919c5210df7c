// The program headless: a script of taps against the truth, refusals by their words.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/sensor/depth_source.h"
#include "render/egl_context.h"
#include "render/image.h"
#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/bracket_files.h"
#include "tests/app/e2e/running_program.h"
#include "tests/app/e2e/sample_files.h"
#include "tests/app/runner/simulated_scene.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "vision/design/design_reader.h"

namespace spool {
namespace {

using nlohmann::json;

bool has_gl() {
  return std::getenv("SPOOL_REQUIRE_GL") != nullptr ||
         render::EglContext::surfaceless().has_value();
}

#define SPOOL_SKIP_WITHOUT_GL() \
  if (!has_gl()) GTEST_SKIP() << "no driver gives an OpenGL ES 3.0 context"

// Appends a tap at `spot` (px of a window of that size) to a script.
void add_tap(json& script, double t_s, const test::Spot& spot, double width, double height) {
  for (const char* phase : {"down", "up"}) {
    script["events"].push_back(
        {{"t_s", t_s}, {"id", 0}, {"phase", phase}, {"x", spot.x / width}, {"y", spot.y / height}});
  }
}

struct Row {
  std::string quality;
  std::optional<Pose> T;
};
std::vector<Row> read_track(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::vector<Row> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    double frame = 0, seconds = 0;
    Row row;
    words >> frame >> seconds >> row.quality;
    std::vector<double> numbers;
    for (double number = 0; words >> number;) numbers.push_back(number);
    row.T = pose_from_row_major(numbers);
    rows.push_back(row);
  }
  return rows;
}

// Two runs: one that says where things stand, one that taps there. Gives the second's result.
struct Scripted {
  test::ProcessResult result;
  std::filesystem::path out, track;
};
Scripted align_by_taps(const std::filesystem::path& folder, const std::vector<std::string>& inputs,
                       const PreparedDesign& design, const Camera& camera, const DepthFrame& frame,
                       const Pose& truth, const std::string& size) {
  Scripted run;
  run.out = folder / "out";
  run.track = folder / "poses.csv";
  std::vector<std::string> look = {test::program("spoolsight").string()};
  look.insert(look.end(), inputs.begin(), inputs.end());
  look.insert(look.end(), {"--headless", "--size", size, "--print-targets", "--out",
                           (folder / "look").string()});
  test::RunningProgram seen(look);  // its first line is enough
  const auto line = seen.next_line(std::chrono::seconds(60));
  EXPECT_TRUE(line.has_value());
  if (!line) return run;
  const json screen = json::parse(*line);
  const double width = screen["width"], height = screen["height"];
  const auto spots = test::choose_three(screen, design, camera, frame, truth);
  EXPECT_EQ(spots.size(), 3U) << "no three points in sight of both";
  if (spots.size() != 3) return run;
  json script{{"events", json::array()}};
  double t = 0;
  for (const test::SpotPair& pair : spots) {
    add_tap(script, t, pair.design, width, height);
    add_tap(script, t + 0.2, pair.scan, width, height);
    t += 0.5;
  }
  // Where Done will stand is known from the layout: the first action above Shot, which is the
  // fourth.
  const auto shot = screen["targets"]["Shot"].get<std::vector<double>>();
  const auto portrait = height > width;
  const double gap = 8;
  const test::Spot done =
      portrait ? test::Spot{shot[0] - 3 * (shot[2] + gap) + 0.5 * shot[2], shot[1] + 0.5 * shot[3]}
               : test::Spot{shot[0] + 0.5 * shot[2], shot[1] - 3 * (shot[3] + gap) + 0.5 * shot[3]};
  add_tap(script, t, done, width, height);
  std::ofstream(folder / "taps.json") << script.dump();
  std::vector<std::string> act = inputs;
  act.insert(act.end(), {"--headless", "--size", size, "--script", (folder / "taps.json").string(),
                         "--track", run.track.string(), "--out", run.out.string()});
  run.result = test::run(test::program("spoolsight"), act);
  return run;
}

TEST(Headless, AScriptOfTapsAlignsTracksAndWritesEverything) {
  SPOOL_SKIP_WITHOUT_GL();
  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 12);
  ASSERT_TRUE(files.prepared);
  const Pose truth = test::T_design_camera();
  const auto frame = test::render_frame(*files.prepared, truth, 0);
  const auto run = align_by_taps(
      folder.path(), {"--design", files.design, "--design-unit", "m", "--source", files.recording},
      *files.prepared, test::small_camera(), *frame, truth, "800x480");
  ASSERT_EQ(run.result.code, 0) << run.result.err;
  EXPECT_EQ(run.result.out, "") << "what is said goes to stderr";
  const auto rows = read_track(run.track);
  ASSERT_EQ(rows.size(), 12U) << "a row for every frame";
  // Frame 0 went by while the finger was down; the picture is held from frame 1 on.
  EXPECT_EQ(rows[0].quality, "lost");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_TRUE(rows[i].T.has_value()) << i;
    // Of a coarse camera it takes some frames until what is known is within 3 mm and 0.3 degrees.
    if (i > 6) {
      EXPECT_EQ(rows[i].quality, "good") << i;
    } else {
      EXPECT_NE(rows[i].quality, "lost") << i;
    }
    const PoseSize error = pose_size(truth.inverse() * *rows[i].T);
    EXPECT_LT(error.translation_m, 0.003);  // every other pixel of a coarse camera is used
    EXPECT_LT(error.rotation_rad, 0.008);
  }
  for (const char* file :
       {"screen_end.png", "report.json", "report.html", "points.ply", "overlay_1.png"}) {
    EXPECT_TRUE(std::filesystem::exists(run.out / file)) << file;
  }
  EXPECT_TRUE(render::read_png(run.out / "screen_end.png").has_value());
}

// A hand-held recording of someone else's simulation (truth in its own files).
TEST(Headless, TracksAHandHeldRecordingToItsTruth) {
  SPOOL_SKIP_WITHOUT_GL();
  SPOOL_REQUIRE_SHARED(scene, "scenes/spool1_handheld");
  const auto matrix = [](const json& rows) {
    std::vector<double> numbers;
    for (const json& row : rows) {
      for (const json& number : row) numbers.push_back(number);
    }
    return pose_from_row_major(numbers).value_or(Pose::Identity());
  };
  json poses;
  std::ifstream(scene / "truth" / "poses.json") >> poses;
  const auto truth = [&](std::size_t i) -> Pose {
    return matrix(poses[i]["design_to_world_bestfit"]).inverse() *
           matrix(poses[i]["camera_to_world"]);
  };
  auto model = read_design(scene / "design" / "model.glb");
  ASSERT_TRUE(model.has_value());
  auto design = PreparedDesign::prepare(std::move(*model));
  ASSERT_TRUE(design.has_value());
  auto source = sensor::open_source(scene.string());
  ASSERT_TRUE(source.has_value());
  auto first = (*source)->next(std::chrono::milliseconds(1000));
  ASSERT_TRUE(first.has_value() && first->frame);
  const test::TemporaryFolder folder;
  const auto run = align_by_taps(
      folder.path(),
      {"--design", (scene / "design" / "model.glb").string(), "--source", scene.string()}, **design,
      (*source)->camera(), *first->frame, truth(0), "800x480");
  ASSERT_EQ(run.result.code, 0) << run.result.err;
  const auto rows = read_track(run.track);
  ASSERT_EQ(rows.size(), poses.size());
  const Eigen::Vector3d centre = (*design)->model.bounds().center();
  std::size_t tracked = 0;
  double worst_m = 0, worst_rad = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].quality == "lost") continue;
    ++tracked;
    // How the drawing's middle is off, and its turn about it.
    const Pose error = *rows[i].T * truth(i).inverse();
    worst_m = std::max(worst_m, (error * centre - centre).norm());
    worst_rad = std::max(worst_rad, pose_size(error).rotation_rad);
  }
  RecordProperty("worst_mm", std::to_string(1e3 * worst_m));
  std::printf("tracked %zu of %zu, worst %.1f mm and %.2f deg\n", tracked, rows.size(),
              1e3 * worst_m, worst_rad * 57.2958);
  EXPECT_GE(tracked, rows.size() * 9 / 10);
  // One frame of 2 mm noise on a 2-inch spool with a defect; a lost or slipped track is centimetres
  // off.
  EXPECT_LT(worst_m, 0.006);
  EXPECT_LT(worst_rad, 0.03);
}

// The sample that the program comes with, by the script it comes with. SPOOL_UPDATE_SAMPLE_TAPS=1
// writes that script anew, as after a change of the layout.
TEST(Headless, TheSamplesTapsAlignItsRecording) {
  SPOOL_SKIP_WITHOUT_GL();
  const test::SampleFiles sample = test::read_sample();
  ASSERT_TRUE(sample.prepared);
  const test::TemporaryFolder folder;
  const std::vector<std::string> inputs{"--design", sample.design, "--source", sample.recording};
  if (std::getenv("SPOOL_UPDATE_SAMPLE_TAPS") != nullptr) {
    static_cast<void>(align_by_taps(folder.path(), inputs, *sample.prepared, sample.camera,
                                    *sample.frames[0], sample.T_design_camera[0], "1280x800"));
    std::filesystem::copy_file(folder.path() / "taps.json", sample.taps,
                               std::filesystem::copy_options::overwrite_existing);
  }
  const std::filesystem::path out = folder.path() / "sample", track = folder.path() / "sample.csv";
  std::vector<std::string> words = inputs;
  words.insert(words.end(), {"--headless", "--script", sample.taps, "--track", track.string(),
                             "--out", out.string()});
  const auto result = test::run(test::program("spoolsight"), words);
  ASSERT_EQ(result.code, 0) << result.err;
  const Eigen::Vector3d centre = sample.prepared->model.bounds().center();
  const auto rows = read_track(track);
  ASSERT_EQ(rows.size(), sample.frames.size());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_NE(rows[i].quality, "lost") << i;
    // 2 mm noise, and a branch turned by 5 degrees that a best fit gives way to a little.
    const Pose error = *rows[i].T * sample.T_design_camera[i].inverse();
    EXPECT_LT((error * centre - centre).norm(), 0.005) << i;
    EXPECT_LT(pose_size(error).rotation_rad, 0.03) << i;
  }
  EXPECT_TRUE(std::filesystem::exists(out / "report.json"));
}

// One press of Find in the place of three taps, by a script of the same kind.
TEST(Headless, TheSampleIsFoundWithNoTapWhereThreeTapsPutIt) {
  SPOOL_SKIP_WITHOUT_GL();
  const test::SampleFiles sample = test::read_sample();
  ASSERT_TRUE(sample.prepared);
  const test::TemporaryFolder folder;
  const auto track_of = [&](const std::filesystem::path& script) {
    const std::filesystem::path track = folder.path() / script.stem();
    const auto result = test::run(
        test::program("spoolsight"),
        {"--design", sample.design, "--source", sample.recording, "--headless", "--script", script,
         "--track", track.string(), "--out", (folder.path() / "out").string()});
    EXPECT_EQ(result.code, 0) << result.err;
    return read_track(track);
  };
  const auto found = track_of(sample.taps.parent_path() / "find.json");
  const auto tapped = track_of(sample.taps);
  ASSERT_EQ(found.size(), sample.frames.size());
  ASSERT_EQ(tapped.size(), sample.frames.size());
  const Eigen::Vector3d centre = sample.prepared->model.bounds().center();
  // The press is made at the fourth frame, 0.1 s in, and held from the next.
  for (std::size_t i = 5; i < found.size(); ++i) {
    ASSERT_NE(found[i].quality, "lost") << i;
    ASSERT_TRUE(found[i].T && tapped[i].T) << i;
    // Begun at different frames; after a few more both have read much the same.
    const Pose apart = *found[i].T * tapped[i].T->inverse();
    if (i >= 10) {
      EXPECT_LT((apart * centre - centre).norm(), 0.002) << i;
      EXPECT_LT(pose_size(apart).rotation_rad, 0.005) << i;
    }
    const Pose error = *found[i].T * sample.T_design_camera[i].inverse();
    EXPECT_LT((error * centre - centre).norm(), 0.005) << i;  // as of three taps
    EXPECT_LT(pose_size(error).rotation_rad, 0.03) << i;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "report.json"));
}

struct Refusal {
  std::string name;
  std::vector<std::string> arguments;
  int code;
  std::string words;
};

TEST(Headless, RefusesInOneSentenceWithTheRightExitCode) {
  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 1);
  const std::string design = files.design.string(), source = files.recording.string();
  std::ofstream(folder.path() / "bad.json")
      << R"({"events": [{"t_s": 0, "id": 0, "phase": "jump", "x": 0, "y": 0}]})";
  std::ofstream(folder.path() / "odd.json") << "[]";
  const std::string out = (folder.path() / "out").string();
  const std::vector<Refusal> table{
      {"no design", {"--source", source, "--headless"}, 64, "--design"},
      {"missing design",
       {"--design", "/nowhere/spool.glb", "--source", source, "--headless"},
       65,
       "/nowhere/spool.glb"},
      {"missing source",
       {"--design", design, "--source", "/nowhere/recording", "--headless"},
       64,
       "/nowhere/recording"},
      {"odd unit",
       {"--design", design, "--source", source, "--headless", "--design-unit", "yard"},
       64,
       "yard"},
      {"odd size",
       {"--design", design, "--source", source, "--headless", "--size", "big"},
       64,
       "--size big"},
      {"missing script",
       {"--design", design, "--source", source, "--headless", "--script", "/nowhere/taps.json"},
       65,
       "/nowhere/taps.json"},
      {"odd script",
       {"--design", design, "--source", source, "--headless", "--script",
        folder.path() / "odd.json"},
       65,
       "no list of events"},
      {"bad script",
       {"--design", design, "--source", source, "--headless", "--script",
        folder.path() / "bad.json"},
       65,
       "event 0"},
  };
  for (const Refusal& row : table) {
    SCOPED_TRACE(row.name);
    std::vector<std::string> arguments = row.arguments;
    arguments.insert(arguments.end(), {"--out", out});
    const auto result = test::run(test::program("spoolsight"), arguments);
    EXPECT_EQ(result.code, row.code) << result.err;
    EXPECT_NE(result.err.find(row.words), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

TEST(Headless, WithoutADisplayTheWindowRecommendsHeadless) {
  const test::TemporaryFolder folder;
  const test::BracketFiles files = test::write_bracket(folder.path(), 1);
  const auto result = test::run(test::program("spoolsight"),
                                {"--design", files.design, "--source", files.recording},
                                {.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
  EXPECT_EQ(result.code, 69);
  EXPECT_NE(result.err.find("--headless"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace spool
