// One hand-held sequence of known truth, tracked: how far off each frame's pose was.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/track_trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "tools/campaign/depth_video.h"
#include "tools/campaign/scene_room.h"
#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool::campaign {
namespace {

constexpr int kParkedFrames = 40;  // filmed; then they come again

Hook hook_before(const Eigen::AlignedBox3d& object) {
  Hook hook;
  hook.pivot = object.center() + Eigen::Vector3d(0, 0, 0.2 + hook.rope_m);
  hook.direction =
      object.sizes().x() > object.sizes().y() ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return hook;
}

double milliseconds(const std::map<std::string, double>& timing_s, const char* stage) {
  const auto found = timing_s.find(stage);
  return found == timing_s.end() ? 0 : 1000 * found->second;
}

}  // namespace

TrackRun run_track(const TrackRow& row, std::uint32_t seed, int most_frames) {
  SceneRequest request{.kind = row.kind, .seed = seed};
  const SceneRoom room = make_room(request);
  const RayWorld world(room.placed);
  HandheldSettings settings;
  settings.pixel_step = row.pixel_step;
  const Camera camera = camera_of(settings);
  const HandMotion hand(world, room.object, row.hand, seed);
  const Hook hook = hook_before(room.object);

  TrackRun run;
  run.period_s = hand.period_s();
  const double seconds = row.seconds > 0 ? row.seconds : hand.period_s();
  int frames = static_cast<int>(std::lround(seconds * row.fps));
  if (most_frames > 0) frames = std::min(frames, most_frames);
  Tracker tracker;
  std::optional<Pose> T_first_scan;
  std::vector<DepthFrame> filmed;
  for (int i = 0; i < frames; ++i) {
    const double now = i / row.fps;
    const double then = row.jump_at_s >= 0 && now >= row.jump_at_s ? now - row.jump_back_s : now;
    const Pose T_scan_camera = hand.T_scan_camera(row.parked ? 0 : then);
    TrackedFrame result;
    result.seconds = now;
    result.is_covered = now >= row.covered_from_s && now < row.covered_to_s;
    DepthFrame frame;
    if (row.parked && i >= kParkedFrames) {
      frame = filmed[static_cast<std::size_t>(i % kParkedFrames)];
      frame.seconds = now;
    } else if (result.is_covered) {
      frame = {i, now, camera.width, camera.height,
               std::vector<std::uint16_t>(static_cast<std::size_t>(camera.width * camera.height))};
    } else if (row.hook) {
      const RayWorld moving(hook_at(hook, now));
      frame = film(world, &moving, settings, T_scan_camera, seed, i, now);
    } else {
      frame = film(world, nullptr, settings, T_scan_camera, seed, i, now);
    }
    if (row.parked && i < kParkedFrames) filmed.push_back(frame);

    const auto start = std::chrono::steady_clock::now();
    auto cloud = back_project(frame, camera);
    estimate_organised_normals(*cloud, camera, {});
    result.prepare_ms =
        1000 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const TrackedPose tracked = tracker.track({*cloud, camera, {}, now});
    if (!T_first_scan && tracked.quality != PoseQuality::kLost)
      T_first_scan = T_scan_camera.inverse();
    result.quality = tracked.quality;
    result.score = tracked.score;
    result.reason = tracked.reason;
    result.sigma_m = largest_sigma(tracked.covariance.topLeftCorner<3, 3>());
    result.sigma_rad = largest_sigma(tracked.covariance.bottomRightCorner<3, 3>());
    if (T_first_scan) {
      const PoseSize off =
          pose_size((*T_first_scan * T_scan_camera).inverse() * tracked.T_map_camera);
      result.off_m = off.translation_m;
      result.off_rad = off.rotation_rad;
    }
    result.fit_ms = milliseconds(tracked.timing_s, "fit");
    result.fuse_ms = milliseconds(tracked.timing_s, "fuse");
    result.cells = tracker.map().size();
    run.frames.push_back(result);
  }
  return run;
}

}  // namespace spool::campaign
