// spoolsight-frame-bench: how long one live frame takes, depth in to pose and deviations out, stage
// by stage.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "app/common/cli.h"
#include "app/common/json_file.h"
#include "app/sensor/depth_source.h"
#include "vision/core/version.h"
#include "vision/design/design_reader.h"
#include "vision/live/frame_processor.h"

namespace spool {
namespace {

struct Arguments {
  std::string design, recording;
  std::size_t frames = 300;
  int runs = 5;
  bool each = false;
};

// A recording in memory and where its frames were really seen from.
struct Sequence {
  Camera camera;
  std::vector<std::shared_ptr<const DepthFrame>> frames;
  std::vector<Pose> T_design_camera;  // one a frame, without the design's origin
};

Pose pose_at(JsonObject& json, const std::string& key) {
  const auto T = pose_from_row_major(json.numbers(key, 16));
  if (!T) json.fail(key, "has to be a rigid pose, 4x4 by rows");
  return T.value_or(Pose::Identity());
}

// The truth.json that spoolsight-simulate writes beside its frames.
Status add_truth(const std::string& folder, const Eigen::Vector3d& design_origin,
                 Sequence& sequence) {
  const std::string path = (std::filesystem::path(folder) / "truth.json").string();
  const auto json = read_json(path);
  if (!json) return json.error();
  JsonObject top(*json, path);
  const Pose T_design_map = pose_at(top, "T_map_design").inverse();
  for (const auto& frame : top.array("frames")) {
    JsonObject one(frame, path, "frames");
    Pose T = T_design_map * pose_at(one, "T_map_camera");
    T.translation() -= design_origin;
    sequence.T_design_camera.push_back(T);
    if (one.error()) return *one.error();
  }
  if (top.error()) return *top.error();
  if (sequence.T_design_camera.size() < sequence.frames.size())
    return Error{ErrorCode::kBadInput,
                 path + ": has fewer poses than the recording frames; simulate both anew"};
  return {};
}

Result<Sequence> read_sequence(const Arguments& arguments, const Eigen::Vector3d& design_origin) {
  auto source = sensor::open_source(arguments.recording);
  if (!source) return source.error();
  Sequence sequence{.camera = (*source)->camera()};
  while (sequence.frames.size() < arguments.frames) {
    const auto output = (*source)->next(std::chrono::milliseconds(100));
    if (!output) return output.error();
    if (output->event == sensor::SourceEvent::kEnd) break;
    if (output->event == sensor::SourceEvent::kFrame) sequence.frames.push_back(output->frame);
  }
  if (sequence.frames.size() < 2)
    return Error{ErrorCode::kBadInput,
                 arguments.recording + ": has fewer than two frames; record a sequence"};
  if (const Status added = add_truth(arguments.recording, design_origin, sequence); !added)
    return added.error();
  return sequence;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Nearest rank: the smallest value that `share` of them do not exceed.
double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

// One walk over the sequence, each frame after its neighbour.
struct Run {
  std::vector<double> wall_s, cpu_s;  // of process(), one a frame
  std::map<std::string, std::vector<double>> stage_s;
  std::map<std::string, int> qualities;  // how many frames ended so
  std::size_t points = 0;                // of the last frame, thinned
  std::vector<double> off_m, off_rad;    // of the tracked frames, against truth
};

Result<Run> walk(const std::shared_ptr<const PreparedDesign>& design, const Sequence& sequence,
                 std::size_t count, bool each) {
  FrameProcessor vision(design, sequence.camera, NoiseModel{});
  const auto first = vision.process(sequence.frames.front());
  if (!first) return first.error();
  if (!vision.align(**first, sequence.T_design_camera.front())->is_tracked())
    return Error{ErrorCode::kBadInput,
                 "the first frame does not show the design where truth.json says; give the design "
                 "that was simulated"};
  Run run;
  const std::size_t last = sequence.frames.size() - 1;
  for (std::size_t n = 1; n <= count; ++n) {
    // There and back again, so that a short recording makes a long walk without a jump.
    const std::size_t at = n % (2 * last) <= last ? n % (2 * last) : 2 * last - n % (2 * last);
    const double cpu_before = cpu_seconds();
    const auto before = std::chrono::steady_clock::now();
    const auto state = vision.process(sequence.frames[at]);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - before;
    run.cpu_s.push_back(cpu_seconds() - cpu_before);
    run.wall_s.push_back(wall.count());
    if (!state) return state.error();
    for (const auto& [stage, seconds] : (*state)->timing_s) run.stage_s[stage].push_back(seconds);
    run.qualities[std::string(name((*state)->quality))] += 1;
    run.points = (*state)->scan.size();
    if (!(*state)->is_tracked()) continue;
    const PoseSize off =
        pose_size(sequence.T_design_camera[at].inverse() * (*state)->T_design_camera);
    run.off_m.push_back(off.translation_m);
    run.off_rad.push_back(off.rotation_rad);
    if (each)
      std::printf("  %4zu %-4s off %5.2f mm %6.3f deg, U %5.2f mm %6.3f deg, seen %.2f; %s\n", n,
                  std::string(name((*state)->quality)).c_str(), 1e3 * off.translation_m,
                  off.rotation_rad * 180 / std::numbers::pi, 1e3 * (*state)->pose_u_m,
                  (*state)->pose_u_rad * 180 / std::numbers::pi, (*state)->agreement,
                  (*state)->hint.c_str());
  }
  return run;
}

// The stages in the order in which a frame goes through them; what is new comes last.
std::vector<std::string> in_order(const std::map<std::string, std::vector<double>>& stage_s) {
  constexpr const char* kOrder[] = {"thin",  "follow",    "follow/fit", "follow/fuse",
                                    "place", "deviation", "refine"};
  std::vector<std::string> names(std::begin(kOrder), std::end(kOrder));
  std::erase_if(names, [&](const std::string& stage) { return !stage_s.contains(stage); });
  for (const auto& [stage, seconds] : stage_s)
    if (std::find(names.begin(), names.end(), stage) == names.end()) names.push_back(stage);
  return names;
}

void print_row(const std::string& what, const std::vector<double>& seconds) {
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  std::printf("| %-11s | %6.2f | %6.2f | %6.2f | %6.2f | %6zu |\n", what.c_str(),
              1e3 * sum / static_cast<double>(std::max<std::size_t>(seconds.size(), 1)),
              1e3 * percentile(seconds, 0.5), 1e3 * percentile(seconds, 0.99),
              1e3 * percentile(seconds, 1), seconds.size());
}

void print(const Run& run, const Camera& camera) {
  std::printf("quietest run (least p99), %zu frames of %dx%d, %zu points thinned\n\n",
              run.wall_s.size(), camera.width, camera.height, run.points);
  std::printf(
      "| ms          |   mean | median |    p99 |  worst | frames |\n"
      "|---|---|---|---|---|---|\n");
  print_row("wall", run.wall_s);
  print_row("processor", run.cpu_s);
  for (const std::string& stage : in_order(run.stage_s)) print_row(stage, run.stage_s.at(stage));
  std::printf("\n");
  for (const auto& [quality, frames] : run.qualities)
    std::printf("%s: %d frames\n", quality.c_str(), frames);
  constexpr double kDegree = std::numbers::pi / 180;
  std::printf(
      "camera in the datum's frame, off the truth: median %.2f mm %.3f deg, p95 %.2f mm %.3f "
      "deg, worst %.2f mm %.3f deg\n",
      1e3 * percentile(run.off_m, 0.5), percentile(run.off_rad, 0.5) / kDegree,
      1e3 * percentile(run.off_m, 0.95), percentile(run.off_rad, 0.95) / kDegree,
      1e3 * percentile(run.off_m, 1), percentile(run.off_rad, 1) / kDegree);
}

Result<int> bench(const Arguments& arguments) {
  auto model = read_design(arguments.design);
  if (!model) return model.error();
  const Eigen::Vector3d origin = model->origin;
  const auto design = PreparedDesign::prepare(*std::move(model));
  if (!design) return design.error();
  const auto sequence = read_sequence(arguments, origin);
  if (!sequence) return sequence.error();
  std::printf("commit %s\n", std::string(commit()).c_str());
  Run quietest;
  double least = 0;
  for (int n = 0; n < arguments.runs; ++n) {
    auto run = walk(*design, *sequence, arguments.frames, arguments.each && n == 0);
    if (!run) return run.error();
    const double p99 = percentile(run->wall_s, 0.99);
    std::printf("run %d: median %.2f ms, p99 %.2f ms\n", n + 1, 1e3 * percentile(run->wall_s, 0.5),
                1e3 * p99);
    if (n > 0 && p99 >= least) continue;
    least = p99;
    quietest = *std::move(run);
  }
  print(quietest, sequence->camera);
  return 0;
}

}  // namespace
}  // namespace spool

int main(int argc, char** argv) {
  CLI::App app("Times the vision of consecutive live frames against the sensor's period.");
  spool::add_common_options(app, "spoolsight-frame-bench");
  spool::Arguments arguments;
  app.add_option("design", arguments.design, "The design that the recording shows")->required();
  app.add_option("recording", arguments.recording,
                 "A depth folder of spoolsight-simulate, its truth.json inside")
      ->required();
  app.add_option("--frames", arguments.frames,
                 "Frames a run; a shorter recording goes there and back")
      ->check(CLI::Range(std::size_t{2}, std::size_t{100000}))
      ->capture_default_str();
  app.add_option("--runs", arguments.runs, "Runs, of which the quietest is told in full")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--each", arguments.each, "A line for each frame of the first run");
  return spool::run_program(app, argc, argv, [&] { return spool::bench(arguments); });
}
