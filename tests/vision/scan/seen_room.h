// A corner of a room with a box, a drum and a ball, as a depth camera sees it from a known place.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vision/core/camera.h"
#include "vision/core/point_cloud.h"
#include "vision/core/pose.h"
#include "vision/scan/noise_model.h"
#include "vision/scan/seen_frame.h"

namespace spool::test {

// Room frame: z up, metres. Everything is solid; rays come from outside.
struct Room {
  bool floor = true, wall_x = true, wall_y = true;  // z = 0, x = 1, y = 1
  std::vector<Eigen::AlignedBox3d> boxes = {};
  struct Ball {
    Eigen::Vector3d middle;
    double radius;
  };
  std::vector<Ball> balls = {};

  // Floor, both walls, two boxes and a ball: no two views of it are alike.
  [[nodiscard]] static Room furnished();
  // Distance (m) from `from` along the unit `direction`; nothing within 6 m: none.
  [[nodiscard]] std::optional<double> cast(const Eigen::Vector3d& from,
                                           const Eigen::Vector3d& direction) const;
};

[[nodiscard]] Camera small_camera(int width = 160, int height = 120);

// T_room_camera of a camera at `from` that looks at `at`, its y axis down.
[[nodiscard]] Pose looking(const Eigen::Vector3d& from, const Eigen::Vector3d& at);

// The organised cloud with normals of one frame. `share_of_noise` of the model's axial noise,
// independent from pixel to pixel, depth in whole counts.
[[nodiscard]] PointCloud see(const Room& room, const Camera& camera, const Pose& T_room_camera,
                             std::uint32_t seed, double share_of_noise = 1);

// An organised cloud of that many counts at every pixel, made by hand.
[[nodiscard]] PointCloud cloud_of(const Camera& camera, const std::vector<std::uint16_t>& depth);

}  // namespace spool::test
