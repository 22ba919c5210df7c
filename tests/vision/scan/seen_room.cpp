// A corner of a room with a box, a drum and a ball, as a depth camera sees it from a known place.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/scan/seen_room.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "vision/scan/back_projection.h"
#include "vision/scan/normals.h"

namespace spool::test {

using Eigen::Vector3d;

Room Room::furnished() {
  Room room;
  room.boxes = {{Vector3d(0.1, 0.2, 0), Vector3d(0.4, 0.45, 0.3)},
                {Vector3d(0.55, 0.5, 0), Vector3d(0.8, 0.9, 0.5)},
                {Vector3d(-0.6, 0.5, 0), Vector3d(-0.3, 0.75, 0.15)}};
  room.balls = {{Vector3d(0.3, -0.15, 0.12), 0.12}, {Vector3d(-0.2, 0.7, 0.2), 0.2}};
  return room;
}

std::optional<double> Room::cast(const Vector3d& from, const Vector3d& direction) const {
  double nearest = 6;
  const auto plane = [&](int axis, double at) {
    const double t = (at - from[axis]) / direction[axis];
    if (t > 0 && t < nearest) nearest = t;
  };
  if (floor) plane(2, 0);
  if (wall_x) plane(0, 1);
  if (wall_y) plane(1, 1);
  for (const Eigen::AlignedBox3d& box : boxes) {
    const Vector3d a = (box.min() - from).cwiseQuotient(direction);
    const Vector3d b = (box.max() - from).cwiseQuotient(direction);
    const double enter = a.cwiseMin(b).maxCoeff();
    if (enter > 0 && enter <= a.cwiseMax(b).minCoeff() && enter < nearest) nearest = enter;
  }
  for (const Ball& ball : balls) {
    const Vector3d to = ball.middle - from;
    const double along = to.dot(direction);
    const double root = along * along - to.squaredNorm() + ball.radius * ball.radius;
    if (root <= 0) continue;
    const double t = along - std::sqrt(root);
    if (t > 0 && t < nearest) nearest = t;
  }
  if (nearest >= 6) return std::nullopt;
  return nearest;
}

Camera small_camera(int width, int height) {
  // The same lens for every size: 58 degrees across.
  const double focal = 575.0 * width / 640;
  return {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)};
}

Pose looking(const Vector3d& from, const Vector3d& at) {
  Pose pose = Pose::Identity();
  pose.translation() = from;
  pose.linear().col(2) = (at - from).normalized();
  pose.linear().col(0) = pose.linear().col(2).cross(Vector3d::UnitZ()).normalized();
  pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
  return pose;
}

PointCloud cloud_of(const Camera& camera, const std::vector<std::uint16_t>& depth) {
  PointCloud cloud = *back_project({0, 0, camera.width, camera.height, depth}, camera);
  estimate_organised_normals(cloud, camera, {});
  return cloud;
}

PointCloud see(const Room& room, const Camera& camera, const Pose& T_room_camera,
               std::uint32_t seed, double share_of_noise) {
  std::mt19937 random{seed};
  std::normal_distribution<double> normal;
  const NoiseModel noise;
  std::vector<std::uint16_t> depth;
  depth.reserve(static_cast<std::size_t>(camera.width * camera.height));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const Vector3d ray = camera.back_project(u, v, 1);
      const auto hit =
          room.cast(T_room_camera.translation(), T_room_camera.linear() * ray.normalized());
      const double off = share_of_noise * normal(random);
      if (!hit) {
        depth.push_back(0);
        continue;
      }
      const double z = *hit / ray.norm();
      depth.push_back(static_cast<std::uint16_t>(
          std::lround((z + off * noise.axial_m(z)) / camera.depth_unit_m)));
    }
  return cloud_of(camera, depth);
}

}  // namespace spool::test
