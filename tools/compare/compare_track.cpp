// spoolsight-compare-track: our tracker beside Open3D's ICP on the same hand-held sequence in one
// run.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "app/common/cli.h"
#include "tools/campaign/depth_video.h"
#include "tools/campaign/hand_motion.h"
#include "tools/campaign/quantile.h"
#include "tools/campaign/scene_room.h"
#include "tools/compare/contender.h"
#include "vision/align/tracker.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool::compare {
namespace {

using campaign::quantile;

// Its own choice of the frame's readings; taking the frame into the map is part of the step.
class Ours final : public Follower {
 public:
  explicit Ours(const Camera& camera) : camera_(camera) {}
  void take(const PointCloud& frame, double seconds) override {
    frame_ = &frame;
    seconds_ = seconds;
  }
  Pose follow() override { return tracker_.track({*frame_, camera_, {}, seconds_}).T_map_camera; }

 private:
  Camera camera_;
  Tracker tracker_;
  const PointCloud* frame_ = nullptr;
  double seconds_ = 0;
};

std::vector<TrackContender> contenders(const Camera& camera, [[maybe_unused]] std::size_t points) {
  std::vector<TrackContender> all;
  all.push_back({"ours", std::make_unique<Ours>(camera)});
#ifdef SPOOL_COMPARE_OPEN3D
  for (TrackContender& one : open3d_track(points)) all.push_back(std::move(one));
#endif
  return all;
}

struct Request {
  int frames = 150, seeds = 2;
  std::size_t points = 2000;
};

// One contender over all sequences. The first frame of each is nobody's.
struct Line {
  std::string name;
  std::vector<double> follow_ms, follow_processor_ms, keep_ms, off_mm, off_deg, end_mm;
};

// Wall time, and processor time of all threads: on a busy machine only the second says anything.
struct Milliseconds {
  double wall = 0, processor = 0;
};

template <class Work>
Milliseconds milliseconds_of(const Work& work) {
  const auto processor = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  };
  const auto start = std::chrono::steady_clock::now();
  const double before = processor();
  work();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor() - before};
}

// What all need: the organised cloud and its normals.
PointCloud prepared(const DepthFrame& frame, const Camera& camera) {
  auto cloud = back_project(frame, camera);
  estimate_organised_normals(*cloud, camera, {});
  return *std::move(cloud);
}

void follow_all(std::uint32_t seed, const Request& request, std::vector<Line>& lines,
                std::vector<double>& prepare_ms) {
  const campaign::SceneRoom room =
      campaign::make_room({.kind = campaign::ObjectKind::kSmallSpool, .seed = seed});
  const campaign::RayWorld world(room.placed);
  campaign::HandheldSettings settings;
  settings.pixel_step = 2;  // as the live path thins a frame of 640x480
  const Camera camera = campaign::camera_of(settings);
  const campaign::HandMotion hand(world, room.object, {}, seed);
  std::vector<TrackContender> all = contenders(camera, request.points);
  lines.resize(all.size());
  const Pose T_first_scan = hand.T_scan_camera(0).inverse();
  for (int i = 0; i < request.frames; ++i) {
    const double now = i / 30.0;
    const Pose T_scan_camera = hand.T_scan_camera(now);
    const DepthFrame frame = campaign::film(world, nullptr, settings, T_scan_camera, seed, i, now);
    PointCloud cloud;
    prepare_ms.push_back(milliseconds_of([&] { cloud = prepared(frame, camera); }).wall);
    for (std::size_t k = 0; k < all.size(); ++k) {
      Follower& follower = *all[k].follower;
      Line& line = lines[k];
      line.name = all[k].name;
      Pose T = Pose::Identity();
      follower.take(cloud, now);
      const Milliseconds follow = milliseconds_of([&] { T = follower.follow(); });
      const Milliseconds keep = milliseconds_of([&] { follower.keep(); });
      if (i == 0) continue;
      const PoseSize off = pose_size((T_first_scan * T_scan_camera).inverse() * T);
      line.follow_ms.push_back(follow.wall);
      line.follow_processor_ms.push_back(follow.processor);
      line.keep_ms.push_back(keep.wall);
      line.off_mm.push_back(1000 * off.translation_m);
      line.off_deg.push_back(off.rotation_rad * 180 / std::numbers::pi);
      if (i + 1 == request.frames) line.end_mm.push_back(1000 * off.translation_m);
    }
  }
}

Result<int> compare(const Request& request) {
  std::vector<Line> lines;
  std::vector<double> prepare_ms;
  for (int seed = 1; seed <= request.seeds; ++seed)
    follow_all(static_cast<std::uint32_t>(seed), request, lines, prepare_ms);
  std::printf(
      "%d sequences of %d frames of 320x240; back-projection and normals, which all need: "
      "%.1f ms (median)\n\n"
      "| %-38s | step ms, median / p99 | processor ms | map ms | off mm, p50 / p95 | degrees, p95 "
      "| at the end, most mm |\n|---|---|---|---|---|---|---|\n",
      request.seeds, request.frames, quantile(prepare_ms, 0.5), "");
  for (const Line& line : lines)
    std::printf("| %-38s | %.2f / %.2f | %.2f / %.2f | %.2f | %.2f / %.2f | %.3f | %.1f |\n",
                line.name.c_str(), quantile(line.follow_ms, 0.5), quantile(line.follow_ms, 0.99),
                quantile(line.follow_processor_ms, 0.5), quantile(line.follow_processor_ms, 0.99),
                quantile(line.keep_ms, 0.5), quantile(line.off_mm, 0.5),
                quantile(line.off_mm, 0.95), quantile(line.off_deg, 0.95),
                quantile(line.end_mm, 1));
  return 0;
}

}  // namespace
}  // namespace spool::compare

int main(int argc, char** argv) {
  CLI::App app{
      "Follows the same hand-held camera with our tracker and with Open3D's ICP, and prints times "
      "and errors."};
  spool::compare::Request request;
  spool::add_common_options(app, "spoolsight-compare-track");
  app.add_option("--points", request.points, "Points of a frame that Open3D gets")
      ->check(CLI::Range(std::size_t{100}, std::size_t{100'000}))
      ->capture_default_str();
  app.add_option("--frames", request.frames, "Of each sequence")
      ->check(CLI::Range(2, 100'000))
      ->capture_default_str();
  app.add_option("--seeds", request.seeds, "Sequences")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  return spool::run_program(app, argc, argv, [&] { return spool::compare::compare(request); });
}
