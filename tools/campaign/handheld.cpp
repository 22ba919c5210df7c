// All points of a hand-held camera's frames, merged by their true poses.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/handheld.h"

namespace spool::campaign {

std::vector<SensedPoint> scan_by_hand(const RayWorld& world, const HandheldSettings& settings,
                                      const std::vector<Pose>& T_scan_camera, std::uint32_t seed) {
  std::vector<SensedPoint> points;
  for (std::size_t i = 0; i < T_scan_camera.size(); ++i) {
    const std::vector<Reading> readings =
        read_frame(world, nullptr, settings, T_scan_camera[i], seed, static_cast<int>(i));
    for (int row = 0; row < settings.rows(); ++row)
      for (int column = 0; column < settings.columns(); ++column) {
        const Reading& reading =
            readings[static_cast<std::size_t>(row * settings.columns() + column)];
        if (reading.z == 0) continue;
        const Eigen::Vector3d ray =
            settings.ray(column * settings.pixel_step, row * settings.pixel_step);
        const Eigen::Vector3d point = T_scan_camera[i] * (ray * reading.z);
        points.push_back({point.cast<float>(), reading.placed->label, reading.placed->instance,
                          static_cast<std::uint8_t>(i)});
      }
  }
  return points;
}

}  // namespace spool::campaign
