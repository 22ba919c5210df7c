// One hand-held sequence of a spool as built, followed from the first frame's picks on.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/live_trial.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include "tools/campaign/depth_video.h"
#include "tools/campaign/random.h"
#include "tools/campaign/scene_design.h"
#include "tools/campaign/scene_room.h"
#include "vision/live/frame_processor.h"

namespace spool::campaign {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// A motion of so much in a random direction, about `centre`.
Pose some_motion(double length_m, double angle_rad, const Eigen::Vector3d& centre, Random& random) {
  Pose motion(Eigen::AngleAxisd(angle_rad, random.direction()));
  motion.translation() = centre - motion.linear() * centre + length_m * random.direction();
  return motion;
}

// The room with the object moved in it.
std::vector<Placed> with_object_moved(std::vector<Placed> placed, const Pose& motion) {
  for (Placed& each : placed)
    if (each.instance != kNoInstance) each.T_scan_patch = motion * each.T_scan_patch;
  return placed;
}

}  // namespace

std::vector<LiveRow> live_rows() {
  HandSettings along;
  along.way = Way::kAlong;
  along.speed_m_s = 0.25;
  constexpr auto kLong = ObjectKind::kPipeSpool3m, kAny = ObjectKind::kRandomSpool;
  std::vector<LiveRow> rows;
  rows.push_back({.name = "small as designed"});
  rows.push_back({.name = "small, elbow 4 degrees", .defects = {{DefectKind::kTurned, 4}}});
  rows.push_back({.name = "small, pipe 6 mm", .defects = {{DefectKind::kLong, 6}}});
  rows.push_back({.name = "small, elbow 90 degrees", .defects = {{DefectKind::kTurned, 90}}});
  rows.push_back(
      {.name = "random, elbow 4 degrees", .kind = kAny, .defects = {{DefectKind::kTurned, 4}}});
  rows.push_back(
      {.name = "random, pipe 20 mm", .kind = kAny, .defects = {{DefectKind::kLong, 20}}});
  rows.push_back(
      {.name = "3 m, elbow 4 degrees", .kind = kLong, .defects = {{DefectKind::kTurned, 4}}});
  rows.push_back({.name = "3 m walked, pipe 6 mm",
                  .kind = kLong,
                  .defects = {{DefectKind::kLong, 6}},
                  .hand = along,
                  .seconds = 12});
  rows.push_back({.name = "small, bump 20 mm", .bump_at_s = 3, .bump_m = 0.02});
  rows.push_back({.name = "small, bump 5 degrees", .bump_at_s = 3, .bump_rad = 5 * kDegree});
  rows.push_back({.name = "random, bump 20 mm", .kind = kAny, .bump_at_s = 3, .bump_m = 0.02});
  rows.push_back(
      {.name = "random, bump 5 degrees", .kind = kAny, .bump_at_s = 3, .bump_rad = 5 * kDegree});
  rows.push_back({.name = "elbow 4, bump 20 mm",
                  .defects = {{DefectKind::kTurned, 4}},
                  .bump_at_s = 3,
                  .bump_m = 0.02});
  return rows;
}

Result<std::vector<LiveFrame>> run_live(const LiveRow& row, std::uint32_t seed) {
  SceneRequest request{.kind = row.kind, .seed = seed, .defects = row.defects};
  const SceneRoom room = make_room(request);
  auto design = prepare_design(room.scene);
  if (!design) return design.error();
  Random random(seed, kBumping);
  const Pose bump = some_motion(row.bump_m, row.bump_rad, room.object.center(), random);
  const RayWorld before(room.placed);
  const RayWorld after(row.bump_at_s < 0 ? std::vector<Placed>{}
                                         : with_object_moved(room.placed, bump));
  HandheldSettings settings;
  settings.pixel_step = 2;  // a frame of 640x480 is thinned as much
  const Camera camera = camera_of(settings);
  const HandMotion hand(before, room.object, row.hand, seed);
  Pose T_design_scan = room.scene.objects.front().T_scan_design.inverse();
  T_design_scan.pretranslate(-(*design)->model.origin);
  FrameProcessor vision(*design, camera, NoiseModel{}, {.stride_px = 1});

  std::vector<LiveFrame> frames;
  for (int i = 0; i < static_cast<int>(30 * row.seconds); ++i) {
    const double now = i / 30.0;
    const bool is_bumped = row.bump_at_s >= 0 && now >= row.bump_at_s;
    const Pose T_scan_camera = hand.T_scan_camera(now);
    const Pose truth =
        is_bumped ? T_design_scan * bump.inverse() * T_scan_camera : T_design_scan * T_scan_camera;
    auto filmed = std::make_shared<DepthFrame>(
        film(is_bumped ? after : before, nullptr, settings, T_scan_camera, seed, i, now));
    const auto start = std::chrono::steady_clock::now();
    Result<VisionStatePtr> state = vision.process(std::move(filmed));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    if (!state) return state.error();
    VisionStatePtr shown = *state;
    if (i == 0) {
      const Eigen::Vector3d middle = (*design)->model.bounds().center();
      shown = vision.align(*shown, some_motion(0.01, kDegree, middle, random) * truth);
      if (!shown->is_tracked())
        return Error{ErrorCode::kBadInput, row.name + ": the first frame does not show the object"};
    }
    const PoseSize off = pose_size(truth.inverse() * shown->T_design_camera);
    const Pose T_map_camera = hand.T_scan_camera(0).inverse() * T_scan_camera;
    const PoseSize camera_off = pose_size(T_map_camera.inverse() * shown->T_map_camera);
    const Eigen::Vector3d middle = (*design)->model.bounds().center();
    const Pose T_apart =
        shown->T_design_camera * shown->T_map_camera.inverse() * T_map_camera * truth.inverse();
    frames.push_back({.seconds = now,
                      .quality = shown->quality,
                      .off_m = off.translation_m,
                      .off_rad = off.rotation_rad,
                      .u_m = shown->pose_u_m,
                      .u_rad = shown->pose_u_rad,
                      .camera_off_m = camera_off.translation_m,
                      .camera_off_rad = camera_off.rotation_rad,
                      .place_off_m = (T_apart * middle - middle).norm(),
                      .place_off_rad = pose_size(T_apart).rotation_rad,
                      .was_moved = shown->was_moved,
                      .wall_ms = 1000 * wall.count(),
                      .hint = shown->hint});
  }
  return frames;
}

}  // namespace spool::campaign
