// One hand-held look at a spool of which one part stands a little off.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/part_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "tools/campaign/depth_video.h"
#include "tools/campaign/random.h"
#include "tools/campaign/scene_design.h"
#include "tools/campaign/scene_room.h"
#include "vision/live/frame_processor.h"

namespace spool::campaign {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLeastShare = 0.05;  // of a part; less gets no number on the screen either

Pose some_motion(double length_m, double angle_rad, const Vector3d& centre, Random& random) {
  Pose motion(Eigen::AngleAxisd(angle_rad, random.direction()));
  motion.translation() = centre - motion.linear() * centre + length_m * random.direction();
  return motion;
}

// Parts of which a frame shows more than a speck; not the first, which is the datum.
std::vector<std::uint16_t> seen_parts(const RayWorld& world, const HandheldSettings& settings,
                                      const Pose& T_scan_camera) {
  constexpr int kStep = 8, kSpeck = 20;  // px, rays
  std::map<std::uint16_t, int> hits;
  for (int v = 0; v < settings.height; v += kStep)
    for (int u = 0; u < settings.width; u += kStep) {
      const Vector3d ray = (T_scan_camera.linear() * settings.ray(u, v)).normalized();
      const auto hit = world.cast(T_scan_camera.translation(), ray, settings.farthest_m);
      if (!hit) continue;
      const Placed& placed = world.placed()[hit->placed];
      if (placed.instance != kNoInstance && placed.label != 0) ++hits[placed.label];
    }
  std::vector<std::uint16_t> parts;
  for (const auto& [label, count] : hits)
    if (count > kSpeck) parts.push_back(label);
  return parts;
}

// How far each part's surface is displaced, where frames saw it.
class Truth {
 public:
  // `as_drawn` and `as_built` hold the same patches; `motion` took one to the other where
  // `part` is.
  Truth(const RayWorld& as_drawn, const RayWorld& as_built, const Pose& motion, std::uint16_t part)
      : as_drawn_(as_drawn), as_built_(as_built), T_drawn_built_(motion.inverse()), part_(part) {}

  void see(const HandheldSettings& settings, const Pose& T_scan_camera) {
    constexpr int kStep = 4;               // px
    constexpr double kLeastFacing = 0.26;  // beyond 75 degrees the sensor gives nothing
    for (int v = 0; v < settings.height; v += kStep)
      for (int u = 0; u < settings.width; u += kStep) {
        const Vector3d ray = (T_scan_camera.linear() * settings.ray(u, v)).normalized();
        const auto hit = as_built_.cast(T_scan_camera.translation(), ray, settings.farthest_m);
        if (!hit) continue;
        const Placed& placed = as_built_.placed()[hit->placed];
        if (placed.instance == kNoInstance) continue;
        const Vector3d built = T_scan_camera.translation() + hit->distance * ray;
        if (-as_built_.normal(hit->placed, built).dot(ray) < kLeastFacing) continue;
        const bool is_off = placed.label == part_;
        const Vector3d drawn = is_off ? T_drawn_built_ * built : built;
        const Vector3d normal = as_drawn_.normal(hit->placed, drawn);
        const auto cell = [](double x) { return static_cast<int>(std::floor(100 * x)); };
        cells_[placed.label].try_emplace({cell(drawn.x()), cell(drawn.y()), cell(drawn.z())},
                                         normal.dot(built - drawn));
      }
  }
  [[nodiscard]] double of(std::uint16_t part) const {
    const auto found = cells_.find(part);
    if (found == cells_.end()) return 0;
    double sum = 0;
    for (const auto& [cell, off] : found->second) sum += off;
    return sum / static_cast<double>(found->second.size());
  }

 private:
  const RayWorld& as_drawn_;
  const RayWorld& as_built_;
  Pose T_drawn_built_;
  std::uint16_t part_;
  std::map<std::uint16_t, std::map<std::array<int, 3>, double>> cells_;
};

}  // namespace

std::vector<PartRow> part_rows() {
  HandSettings near;
  near.nearest_m = 0.6;
  near.farthest_m = 1.0;
  HandSettings still = near;
  still.speed_m_s = 0.01;
  still.turn_rad_s = kDegree;
  HandSettings along = near;
  along.way = Way::kAlong;
  along.speed_m_s = 0.25;
  std::vector<PartRow> rows;
  rows.push_back({.name = "small", .hand = near});
  rows.push_back({.name = "small, camera held still", .hand = still});
  rows.push_back({.name = "random", .kind = ObjectKind::kRandomSpool, .hand = near});
  rows.push_back({.name = "3 m, walked", .kind = ObjectKind::kPipeSpool3m, .hand = along});
  return rows;
}

Result<std::vector<TriedPart>> run_part(const PartRow& row, std::uint32_t seed) {
  const SceneRoom room = make_room({.kind = row.kind, .seed = seed});
  auto design = prepare_design(room.scene);
  if (!design) return design.error();
  const std::vector<Part>& parts = (*design)->model.parts;
  Random random(seed, kBumping);
  std::vector<Placed> moved = room.placed;
  const RayWorld as_drawn(room.placed);
  HandheldSettings settings;
  settings.pixel_step = 2;  // a frame of 640x480 is thinned as much
  const HandMotion hand(as_drawn, room.object, row.hand, seed);
  const std::vector<std::uint16_t> seen = seen_parts(as_drawn, settings, hand.T_scan_camera(0));
  if (seen.empty())
    return Error{ErrorCode::kBadInput, row.name + ": the first frame does not show the object"};
  const std::uint16_t off =
      seen[static_cast<std::size_t>(random.below(static_cast<int>(seen.size())))];
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = 0; i < moved.size(); ++i)
    if (moved[i].instance != kNoInstance && moved[i].label == off) box.extend(as_drawn.box(i));
  const Pose motion = some_motion(row.off_m, row.off_rad, box.center(), random);
  for (Placed& each : moved)
    if (each.instance != kNoInstance && each.label == off)
      each.T_scan_patch = motion * each.T_scan_patch;
  const RayWorld as_built(std::move(moved));
  Truth truth(as_drawn, as_built, motion, off);

  Pose T_design_scan = room.scene.objects.front().T_scan_design.inverse();
  T_design_scan.pretranslate(-(*design)->model.origin);
  FrameProcessor vision(*design, camera_of(settings), NoiseModel{}, {.stride_px = 1});
  VisionStatePtr state;
  for (int i = 0; i < static_cast<int>(30 * row.seconds); ++i) {
    const double now = i / 30.0;
    const Pose T_scan_camera = hand.T_scan_camera(now);
    auto next = vision.process(std::make_shared<DepthFrame>(
        film(as_built, nullptr, settings, T_scan_camera, seed, i, now)));
    if (!next) return next.error();
    state = *next;
    if (i % 3 == 0) truth.see(settings, T_scan_camera);
    if (i > 0) continue;
    const Vector3d middle = (*design)->model.bounds().center();
    state = vision.align(
        *state, some_motion(0.01, kDegree, middle, random) * T_design_scan * T_scan_camera);
    if (!state->is_tracked())
      return Error{ErrorCode::kBadInput, row.name + ": the first frame does not show the object"};
  }
  const auto& members = room.scene.design.members;
  std::vector<TriedPart> tried;
  for (std::size_t part = 0; part < state->coverage.parts.size(); ++part) {
    const PartReading& reading = state->coverage.parts[part];
    if (!reading.is_seen || reading.coverage < kLeastShare) continue;
    const auto member = std::ranges::find(members, parts[part].name,
                                          [](const Member& each) { return each.spec.name; });
    const auto label = static_cast<std::uint16_t>(member - members.begin());
    tried.push_back({parts[part].name, label == off, truth.of(label), reading.mean_m, reading.u_m,
                     reading.coverage});
  }
  return tried;
}

}  // namespace spool::campaign
