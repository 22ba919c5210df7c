// What a hand-held depth camera films, frame by frame, as a driver would deliver it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/depth_video.h"

#include <cmath>
#include <numbers>

#include "tools/campaign/labels.h"

namespace spool::campaign {

using Eigen::Vector3d;

Camera camera_of(const HandheldSettings& settings) {
  // Pixel u of the small image is pixel u * step of the large one.
  const double step = settings.pixel_step;
  Camera camera{settings.columns(),
                settings.rows(),
                settings.focal_px / step,
                settings.focal_px / step,
                0.5 * (settings.width - 1) / step,
                0.5 * (settings.height - 1) / step};
  camera.depth_unit_m = 0.001;
  return camera;
}

std::vector<Placed> hook_at(const Hook& hook, double seconds) {
  const double angle = hook.swing_rad * std::sin(2 * std::numbers::pi * hook.hertz * seconds);
  Pose hanging = Pose::Identity();
  hanging.translation() = hook.pivot;
  hanging.rotate(Eigen::AngleAxisd(angle, hook.direction.cross(Vector3d::UnitZ()).normalized()));
  const Pose block = hanging * Eigen::Translation3d(0, 0, -hook.rope_m);
  return {{Patch{Cylinder{0.02, -hook.rope_m, 0}}, hanging, kStructure, kNoInstance},
          {Patch{Block{{0.07, 0.05, 0.1}}}, block, kStructure, kNoInstance}};
}

DepthFrame film(const RayWorld& world, const RayWorld* moving, const HandheldSettings& settings,
                const Pose& T_scan_camera, std::uint32_t seed, int index, double seconds) {
  DepthFrame frame{index, seconds, settings.columns(), settings.rows(), {}};
  const auto readings = read_frame(world, moving, settings, T_scan_camera, seed, index);
  frame.depth.reserve(readings.size());
  for (const Reading& reading : readings)
    frame.depth.push_back(static_cast<std::uint16_t>(std::lround(1000 * reading.z)));
  return frame;
}

}  // namespace spool::campaign
